// Who examines one lab: its rubric and its exam, kept from one submission to the next.
#pragma once

#include "exam/exam.h"

#include <stdbool.h>

typedef struct GradeOptions {
    ContextKind context;
    double seconds;  // that a submission may run, per lab
    double patience; // see client.h
    uint64_t seed;
    const Jail *jail; // NULL: their author grades them, outside
    bool untimed;     // do not compare times with the solution's
    bool evidence;    // keep pictures of what failed in the result
} GradeOptions;

typedef struct Examiner {
    Rubric rubric;
    Roster roster;
    Exam *exam; // NULL until it is first needed
} Examiner;

// Reads the rubric of the lab "03". False with a message.
bool examiner_open(Examiner *examiner, const char *id);

// The exam of the options' seed; drawn the first time, or read where there are no solutions. Ours until
// examiner_forget or examiner_close. NULL with a message.
Exam *examiner_exam(Examiner *examiner, const GradeOptions *options);

// Stops what draws the exam until a picture is wanted that it has not got: it holds some 200 MiB a lab.
void examiner_rest(Examiner *examiner);

// Frees the exam and stops what draws it, but keeps the rubric.
void examiner_forget(Examiner *examiner);
void examiner_close(Examiner *examiner); // accepts a zeroed examiner
