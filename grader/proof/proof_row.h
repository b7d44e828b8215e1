// One row of a rubric's proof: a solution, a skeleton, a mistake or an alternative, graded over some seeds.
#pragma once

#include "exam/exam.h"

#include <stdbool.h>

typedef enum ProofKind {
    KIND_SOLUTION,
    KIND_SKELETON,
    KIND_PARTIAL,
    KIND_MISTAKE,
    KIND_ALTERNATIVE
} ProofKind;

typedef struct ProofRow {
    ProofKind kind;
    int number; // of the task or of the mistake in the rubric
    Solved solved;
    const Change *change;
    const struct ProofRow *before; // of a partial solution: the one with a task less
    double earned;                 // percent, of the last run, by the tasks up to its own
    double lowest, highest;        // percent
    int right, seeds;              // runs graded as they should be
    WorkerClient contender;        // a worker of its own, kept over the seeds
    char other[128];               // a diagnosis that was not the mistake's name, or a check that went wrong
} ProofRow;

// Grades it with one more seed's exam as if it were a submission: by a worker of its own, but for frames that
// are known from the second seed on. Fills in all but what it is. False with a message when something of ours
// cannot be drawn. The caller stops row->contender.
bool proof_row_run(ProofRow *row, Exam *exam, Painters *painters);
