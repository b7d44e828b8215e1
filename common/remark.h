// What can be said of a frame beside its points, from what OpenGL and its compiler know: objects that are
// made anew in each frame, and uniforms that are set in vain.
#pragma once

#include <stdbool.h>

// Forgets all, before a frame.
void remark_clear(void);

// Do the lab's passes run? Only then it is told what is made.
void remark_passes(bool run);

// A call of OpenGL, by its name.
void remark_call(const char *name);

// A uniform is set that the compiler has removed, as nothing needs it. Not those that draw_begin and
// draw_objects set.
void remark_idle_uniform(const char *name);

// A line for each of them, without numbers, so that the same remark is the same text in each frame; "" for
// none. Valid until the next remark.
const char *remark_text(void);
