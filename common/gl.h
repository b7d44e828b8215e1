// OpenGL 4.1 core through glad, each call checked: the first failing one is kept with its name.
#pragma once

#include <glad/gl.h>

#include <stdbool.h>
#include <stddef.h>

// Loads the functions of the current context and starts to watch them. False when it is older than 4.1.
bool gl_load(GLADloadfunc load);

// "GL_INVALID_ENUM in glTexImage2D" of the first failing call since gl_clear_error; "" when all is well.
// Where the call stands in lab.so, gl_append_caller's mark follows.
const char *gl_error(void);
void gl_clear_error(void);

// Appends " @0xOFFSET@" of the innermost of the `count` return addresses that lies in lab.so (for addr2line).
void gl_append_caller(char *text, size_t size, void *const *frames, int count);

// Checks that the framebuffer bound to GL_FRAMEBUFFER is complete, or where it was unbound already (0), the
// last one that was bound. The message names `what` and the reason.
bool gl_check_framebuffer(const char *what);

// From now on no framebuffer counts as the last one that was bound.
void gl_forget_framebuffer(void);
