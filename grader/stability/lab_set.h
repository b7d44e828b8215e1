// The labs of a suite, each opened when it is first asked for.
#pragma once

#include "study/lab_artist.h"

#include <stdbool.h>
#include <stdint.h>

enum { BENCH_LABS = 16, BENCH_FAULTED = 48 };

// A row's change of the lab that has the fault: made in what the fault's edits left.
typedef struct Faulted {
    const Change *change;
    Change both;
    bool fits; // else the change's texts are gone, or the two together do not compile
} Faulted;

typedef struct LabSet {
    LabArtist artists[BENCH_LABS];
    int count;
    uint32_t without;              // as LabArtist has it
    const char *fault_lab, *fault; // a catalogued mistake that this lab is drawn with; NULL: none
    Faulted faulted[BENCH_FAULTED];
    int faulted_count;
} LabSet;

// The lab's solution, drawn with `change` (NULL: none) and the bench's fault from now on. Where the two do
// not go together, with the change alone. NULL with a message. Belongs to the bench, and so do its settings:
// the next call for this lab changes them.
LabArtist *lab_set_artist(LabSet *labs, const char *lab, const Change *change);

// The most objects that a scene had which was drawn since the last call.
int lab_set_most_objects(LabSet *labs);

void lab_set_close(LabSet *labs); // accepts a zeroed bench
