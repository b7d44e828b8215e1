// The references of a copy without solutions, as the student's kit is one: what the grader asks for the
// recorded seeds, with what the solution drew. One of these frames is open at a time.
#pragma once

#include "exam/exam.h"

#include <stdbool.h>

enum { RECORDED_MOST_SEEDS = 100 };

typedef struct Recorded {
    const Rubric *rubric;
    uint64_t seeds[RECORDED_MOST_SEEDS];
    int seed_count;           // 0: nothing is recorded here
    int seed, check, variant; // of the open frame; seed: number in `seeds`
    bool open;
    Variant frame; // its scene, request and reference
} Recorded;

// Finds out what is recorded. False with a message when nothing is, or when the lab has solutions here.
bool recorded_begin(Recorded *recorded, const Rubric *rubric);
void recorded_end(Recorded *recorded); // accepts a zeroed one

// Opens the frame that is nearest to what is looked at: of the check (-1: none), else of one with this view
// and scene, else of one with this view, else of the whole picture; with this scene and seed, where that is
// recorded. False with a message.
bool recorded_open(Recorded *recorded, int check, const char *view, const char *scene, uint64_t seed);

// Opens the first frame of the next check (1) or of the last one (-1).
bool recorded_step_check(Recorded *recorded, int direction);

// Opens the next variant of the check or the last one, through all seeds, in a circle.
bool recorded_step_variant(Recorded *recorded, int direction);
