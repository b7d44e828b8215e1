// The state in which a frame begins, and a first texture.
#pragma once

#include "gl.h"

// Everything a pass may have touched goes back to the state in which a frame begins: depth test on (GL_LESS),
// back faces culled, nothing bound, no blending, stencil, scissor or polygon offset, all masks open.
void gl_reset(void);

// A 2D texture without size, texels or filters yet: clamped to its edge, its red
// channel shown as grey. Bound.
GLuint gl_create_grey_texture(void);
