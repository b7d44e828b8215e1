// A framebuffer of textures to draw into: what lab 02 builds by hand, finished for the labs after it.
#pragma once

#include "gl.h"

#include <stdbool.h>

typedef struct Target {
    GLuint framebuffer;
    GLuint color, depth; // textures, 0 where the target has none
    int width, height;
} Target;

// `color_format` and `depth_format` are sized internal formats (GL_RGBA8, GL_DEPTH_COMPONENT24, ...), 0 for
// none. Textures are GL_NEAREST and clamped to the edge. GL_FRAMEBUFFER stays bound to the new target.
bool target_create(Target *target, int width, int height, GLenum color_format, GLenum depth_format);
void target_destroy(Target *target); // accepts a zeroed target

// One such texture, for a framebuffer that is made by hand.
GLuint target_create_texture(int width, int height, GLenum internal_format);

// Binds the framebuffer and sets the viewport to all of it.
void target_bind(const Target *target);
