// The labs of a suite, each opened when it is first asked for.
#pragma once

#include "study/lab_artist.h"

#include <stdbool.h>

enum { BENCH_LABS = 16 };

typedef struct Bench {
    Artist artists[BENCH_LABS];
    int count;
    const char *fault_lab, *fault; // a catalogued mistake that this lab is drawn with; NULL: none
} Bench;

// The lab's solution, drawn with `change` from now on; NULL: as it is, or with the bench's fault. NULL with a
// message. Belongs to the bench, and so do its settings: the next call for this lab changes them.
Artist *bench_artist(Bench *bench, const char *lab, const Change *change);

void bench_close(Bench *bench); // accepts a zeroed bench
