// The labs of a suite, each opened when it is first asked for.
#pragma once

#include "study/lab_artist.h"

#include <stdbool.h>

enum { BENCH_LABS = 16 };

typedef struct LabSet {
    LabArtist artists[BENCH_LABS];
    int count;
    const char *fault_lab, *fault; // a catalogued mistake that this lab is drawn with; NULL: none
} LabSet;

// The lab's solution, drawn with `change` from now on; NULL: as it is, or with the bench's fault. NULL with a
// message. Belongs to the bench, and so do its settings: the next call for this lab changes them.
LabArtist *lab_set_artist(LabSet *labs, const char *lab, const Change *change);

void lab_set_close(LabSet *labs); // accepts a zeroed bench
