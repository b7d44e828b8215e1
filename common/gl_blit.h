// What a driver may let pass in glBlitFramebuffer although OpenGL forbids it.
#pragma once

#include <glad/gl.h>

#include <stdbool.h>

// Do the depth attachments of the bound framebuffers for reading and drawing have different formats? A copy
// of depths between them is an invalid operation (OpenGL 4.1 core, 4.3.2); Mesa copies all the same, others
// refuse. False when one of them has no depth. Changes no state.
bool gl_blit_mixes_depths(void);
