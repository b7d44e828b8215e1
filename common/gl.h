// OpenGL 4.1 core through glad, each call checked: the first failing one is kept with its name.
#pragma once

#include <glad/gl.h>

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

// Loads the functions of the current context and starts to watch them. False when it is older than 4.1.
bool gl_load(GLADloadfunc load);

// "GL_INVALID_ENUM in glTexImage2D" of the first failing call since gl_clear_error; "" when all is well.
const char *gl_error(void);
// Where that call stands in lab.so: an offset for addr2line; 0 when it is not from there.
unsigned long gl_error_place(void);
void gl_clear_error(void);

// Did a call fail since gl_clear_error with anything but GL_INVALID_ENUM? A refused call should change
// nothing, but drivers differ in how they keep to that; with a name that it does not know, none does
// anything.
bool gl_refused(void);

// The offset in lab.so of the innermost of the `count` return addresses that lies in it; 0 when none does.
unsigned long gl_caller(void *const *frames, int count);

// Checks that the framebuffer bound to GL_FRAMEBUFFER is complete, or where it was unbound already (0), the
// last one that was bound. The message names `what` and the reason.
bool gl_check_framebuffer(const char *what);

// Who watches is told of each call before it is done: its name, how many arguments it has, and these. NULL:
// nobody.
typedef void (*GlWatch)(const char *name, int count, va_list arguments);
void gl_watch(GlWatch watch);

// Waits until what shaders have written into buffers can be read. False: this OpenGL, older than 4.2, has no
// shaders that write.
bool gl_finish_writes(void);

// Unbinds all textures and samplers of the first `units` units, by two calls of OpenGL 4.4. False: the driver
// has not got them.
bool gl_unbind_textures(GLuint units);

// From now on no framebuffer counts as the last one that was bound.
void gl_forget_framebuffer(void);
