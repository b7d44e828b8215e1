// Grades one submission of one lab.
#pragma once

#include "exam.h"
#include "result.h"

#include <stdbool.h>

typedef struct GradeOptions {
    ContextKind context;
    double seconds;     // that a submission may run, per lab
    const char *output; // folder for pictures of what failed, NULL for none
    uint64_t seed;
} GradeOptions;

// An empty result with the checks of the rubric.
void grade_begin(LabResult *result, const Rubric *rubric);

// Draws the exam's frames with the student's worker and scores them; the frames stay in the result, which
// grade_begin has prepared. With a roster the solution draws some again, in turn with the student, to compare
// their times.
void grade_frames(LabResult *result, const Exam *exam, Client *student, Roster *roster);

// The whole way of one lab: takes the files from `submission`, compiles, draws, scores, names the mistakes.
// Everything that a submission can do wrong ends in the result; false with a message is a fault of ours
// (could not grade).
bool grade_lab(LabResult *result, const Rubric *rubric, const char *submission, const GradeOptions *options,
               char renderer[128]);

// The same with an exam and a roster of the caller's, so that a lab is graded again without drawing anew what
// ours draw. A zeroed exam is drawn first, from options->seed; later gradings keep its variants.
bool grade_by_exam(LabResult *result, Exam *exam, Roster *roster, const char *submission,
                   const GradeOptions *options);
