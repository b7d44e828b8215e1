// How far the study is: a bar on a terminal, else a line for each scene.
#pragma once

#include <stdbool.h>

typedef struct Progress {
    bool terminal;
    double started; // seconds; when this scene began
    const char *scene;
    int done, all; // steps of this scene
    int began;     // how many were done when it began
    int shown;     // percent
} Progress;

// A scene of `all` steps, of which `done` were done in an earlier run. Writes to stderr.
void progress_begin(Progress *progress, const char *scene, int done, int all);
void progress_step(Progress *progress);
void progress_end(Progress *progress);
