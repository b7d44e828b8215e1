// The state in which a frame begins, and a first texture.
#pragma once

#include "gl.h"

// The state of a new context, whatever was left behind, so that no frame depends on those before it; but with
// the depth test on (GL_LESS) and back faces culled. So: nothing bound, neither a framebuffer, everything
// else off, all masks open, queries and transform feedback ended. What belongs to an object that a lab made,
// like the filter of a texture, stays.
void gl_reset(void);

// A 2D texture without size, texels or filters yet: clamped to its edge, its red
// channel shown as grey. Bound.
GLuint gl_create_grey_texture(void);
