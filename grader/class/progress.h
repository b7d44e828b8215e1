// Says how far a class run is: a bar on a terminal, else a line a submission.
#pragma once

#include <stdbool.h>
#include <stdio.h>

typedef struct Progress {
    FILE *out;
    bool bar;
    int total, finished, failed; // submissions; those finished earlier count, too
    int earlier;                 // finished before this run
    double start;
} Progress;

void progress_begin(Progress *progress, FILE *out, int total, int earlier);

// One more is finished. `name` is as escape_name gives it, `result` what is said about it.
void progress_step(Progress *progress, const char *name, const char *result, bool failed);
void progress_end(const Progress *progress);
