// How far the study is: a bar on a terminal, else a line for each scene.
#pragma once

#include <stdbool.h>

typedef struct Bar {
    bool terminal;
    double started; // seconds; when this scene began
    const char *scene;
    int done, all; // steps of this scene
    int began;     // how many were done when it began
    int shown;     // percent
} Bar;

// A scene of `all` steps, of which `done` were done in an earlier run. Writes to stderr.
void bar_begin(Bar *bar, const char *scene, int done, int all);
void bar_step(Bar *bar);
void bar_end(Bar *bar);
