// The frames that a lab is graded by: for each check of the rubric some variants drawn from a seed, with what
// the solution draws for them, what it draws without the check's task and what the skeleton draws.
//
// Interface: exam_create draws them from a seed (exam_restore: only the requests), exam_destroy frees them.
// Then read exam->variants[check][n]; ask exam_mistake, exam_partial and exam_also for more pictures of one.
// exam_acceptable says which variants are taken.
#pragma once

#include "exam/painters.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct Variant {
    const char *scene; // its name; the rubric's
    Request request;
    Image reference, without, skeleton;
    FrameFacts facts;   // of the reference
    float milliseconds; // that the solution took for it; 0: not known
} Variant;

// One more picture of a variant, kept once it was asked for.
typedef struct LatePicture {
    bool known;
    bool drawn; // false: ours gave a reason why it drew nothing, which counts as black
    FrameFacts facts;
    Image image; // owned; empty when it is the reference's
} LatePicture;

typedef enum ExamEntry { EXAM_UNKNOWN, EXAM_PASSES, EXAM_FAILS } ExamEntry;
typedef enum ExamHidden { EXAM_HIDDEN_UNKNOWN, EXAM_HIDDEN, EXAM_SEEN } ExamHidden;

typedef struct Exam {
    const Rubric *rubric;
    Painters *painters; // draws what is asked for later; NULL when everything was recorded
    uint64_t seed;
    bool scarce; // after exam_create has failed: the seed gives too few variants, and another may do
    Variant variants[RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
    int tries[RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS]; // which of the drawn variants each one is, from 0
    char renderer[128];
    LatePicture mistakes[EXAM_MAX_MISTAKES][RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
    LatePicture partials[EXAM_MAX_TASKS][RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
    ExamEntry without_task[EXAM_MAX_TASKS][RUBRIC_MAX_CHECKS]; // see exam_matrix.h
    LatePicture also[RUBRIC_MAX_ALSO][RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
    Parts *parts; // owned; NULL until exam_reset.h needs them
    LatePicture resets[EXAM_MAX_PARTS][RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS];
    ExamHidden hidden[EXAM_MAX_PARTS][EXAM_MAX_PARTS][RUBRIC_MAX_CHECKS]; // see exam_reset.h
} Exam;

// Is variants[n], drawn, worth asking beside those before it? The task and the whole lab must each change at
// least 1 % of its pixels, and nothing cheap scores in it: black, the mean colour and the references of the
// other variants all get 0.
bool exam_acceptable(const Variant *variants, int n);

// Draws the variants, all of them acceptable. The painters must outlive the exam.
bool exam_create(Exam *exam, const Rubric *rubric, Painters *painters, uint64_t seed);
void exam_destroy(Exam *exam); // accepts a zeroed exam

// Frees what was drawn later when that is more than `most` bytes; it is drawn again when it is asked for.
// Pointers to such pictures end. Nothing of a recorded exam is freed.
void exam_forget_late(Exam *exam, size_t most);

// The same requests as exam_create makes, from its `tries`, but no pictures. False with a message.
bool exam_restore(Exam *exam, const Rubric *rubric, uint64_t seed,
                  int tries[RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS]);

// In which order the variants of check c are asked for: drawn from the seed, so that the number of a frame
// tells nothing of what is in it. (Checks keep their order: whose time is over has the points of the first
// tasks.)
void exam_order(const Exam *exam, int c, int order[EXAM_MAX_VARIANTS]);

// The picture of mistake m in variant n of check c; NULL with a message when our own worker fails. Valid
// while the exam is.
const Image *exam_mistake(Exam *exam, int m, int c, int n);

// The same of our lab solved up to the task with number t ("3.4" for 4); NULL also when no check is about it.
const Image *exam_partial(Exam *exam, int t, int c, int n);

// The same of the a-th alternative whose other pictures are right, too ("also right" in the rubric).
const Image *exam_also(Exam *exam, int a, int c, int n);

// Draws a late picture of the variant and keeps it. NULL with a message when there is no painter or ours
// cannot draw. For this room, as is exam_shown: the picture of a late one that is known.
const Image *exam_shown(const LatePicture *late, const Variant *variant);
const Image *exam_late(LatePicture *late, const Exam *exam, const Variant *variant, const Painter *painter);

// Sum of the pass times of a reply.
float exam_milliseconds(const Reply *reply);
