// The frames that a lab is graded by: for each check of the rubric some variants drawn from a seed, with what
// the solution draws for them, what it draws without the check's task and what the skeleton draws.
#pragma once

#include "roster.h"

#include <stdbool.h>
#include <stdint.h>

enum { EXAM_MAX_VARIANTS = 8, EXAM_MAX_MISTAKES = 40 };

typedef struct Variant {
    Request request;
    Image reference, without, skeleton;
} Variant;

typedef struct Exam {
    const Rubric *rubric;
    uint64_t seed;
    Variant variants[RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
    char renderer[128];
    // What the catalogued mistakes draw, kept once it was asked for (exam_mistake).
    Image mistakes[EXAM_MAX_MISTAKES][RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
} Exam;

// Is variants[n], drawn, worth asking beside those before it? The task and the whole lab must each change at
// least 1 % of its pixels, and nothing cheap scores in it: black, the mean colour and the references of the
// other variants all get 0.
bool exam_acceptable(const Variant *variants, int n);

// Draws the variants, all of them acceptable.
bool exam_create(Exam *exam, const Rubric *rubric, Roster *roster, uint64_t seed);
void exam_destroy(Exam *exam); // accepts a zeroed exam

// The picture of mistake m in variant n of check c; NULL with a message when our own worker fails.
const Image *exam_mistake(Exam *exam, Roster *roster, int m, int c, int n);

// Sum of the pass times of a reply.
float exam_milliseconds(const Reply *reply);
