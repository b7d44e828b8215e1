// Says why checks failed: a task is not done, or where the fault is, which known mistake it is, and what is
// wrong with the pictures.
//
// Interface: diagnose, after grade_frames has filled the result; evidence_attach (evidence.h) adds pictures.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

// How the part with the fault is looked for.
typedef enum FaultSearch {
    FAULT_BY_PICTURES, // not at all: the pictures and which checks fail tell
    FAULT_BY_RESET,    // with the submission's parts as they were handed out (reset.h); no solution is needed
    FAULT_BY_SWAP      // with ours in their place (swap.h), where there are solutions; else by reset
} FaultSearch;

// Fills the causes of failed checks and the lab's summary. `student` has the submission's folder, jail and
// context. A search takes up to some 1.5 s. False with a message when one of our own workers fails.
bool diagnose(LabResult *result, Exam *exam, const WorkerClient *student, FaultSearch search);
