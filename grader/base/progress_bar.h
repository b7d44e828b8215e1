// Says how far a long run is: a bar on a terminal, else lines.
#pragma once

#include <stdbool.h>
#include <stdio.h>

typedef struct ProgressBar {
    FILE *out;
    const char *label; // what runs; outlives the bar
    bool terminal;
    int total, done, failed; // steps; those of an earlier run count, too
    int earlier;             // done in an earlier run
    double start;            // seconds, as process_now gives them
} ProgressBar;

// A run of `total` steps, of which `earlier` were done in an earlier run.
void progress_bar_begin(ProgressBar *bar, FILE *out, const char *label, int total, int earlier);

// One more step is done. `line` says something about it, or is NULL: a terminal shows it only when the step
// failed.
void progress_bar_step(ProgressBar *bar, const char *line, bool failed);

// Removes the bar. Returns the seconds since the beginning.
double progress_bar_end(const ProgressBar *bar);
