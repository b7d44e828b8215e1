// Says how far a class run is: a bar on a terminal, else a line a submission.
#pragma once

#include <stdbool.h>
#include <stdio.h>

typedef struct Ticker {
    FILE *out;
    bool bar;
    int total, finished, failed; // submissions; those finished earlier count, too
    int earlier;                 // finished before this run
    double start;
} Ticker;

// Of `total` submissions, `earlier` were finished before.
void ticker_begin(Ticker *ticker, FILE *out, int total, int earlier);

// One more is finished. `name` is as printable_name gives it, `result` what is said about it.
void ticker_step(Ticker *ticker, const char *name, const char *result, bool failed);
void ticker_end(const Ticker *ticker); // ends the line of the bar
