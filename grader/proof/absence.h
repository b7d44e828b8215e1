// The exam in which one object, or one light, of one scene is missing.
#pragma once

#include "exam/exam.h"

#include <stdbool.h>

typedef struct Absence {
    const char *scene; // outlives the absence
    int thing;         // an object, or behind SCENE_MAX_OBJECTS a light
    bool unfit;        // the grader would not ask one of the variants any more
    Exam *exam;        // owned; its variants of other scenes are those of the whole exam
    bool lacks[RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS]; // the variants without the thing, whose pictures are
                                                      // its own
} Absence;

// Draws the variants that have the thing without it; the whole exam must outlive the absence. False with a
// message when ours cannot be drawn.
bool absence_create(Absence *absence, const Exam *whole, const char *scene, int thing);
void absence_destroy(Absence *absence); // accepts a zeroed one

// Has the check a variant that lacks it?
bool absence_concerns(const Absence *absence, int c);

// Draws what ours shows of the variant's request: the solution (with its facts), the solution without the
// task, the skeleton. False with a message.
bool absence_draw_variant(Variant *variant, Painters *painters, const char *task);
