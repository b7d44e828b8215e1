// How far the study is: a bar on a terminal, else a line for each scene.
#pragma once

#include <stdbool.h>

typedef struct ProgressBar {
    bool terminal;
    double started; // seconds; when this scene began
    const char *scene;
    int done, all; // steps of this scene
    int began;     // how many were done when it began
    int shown;     // percent
} ProgressBar;

// A scene of `all` steps, of which `done` were done in an earlier run. Writes to stderr.
void progress_bar_begin(ProgressBar *bar, const char *scene, int done, int all);
void progress_bar_step(ProgressBar *bar);
void progress_bar_end(ProgressBar *bar);
