// Says why checks failed: a task is not done, or where the fault is, which known mistake it is, and what is
// wrong with the pictures.
//
// Interface: diagnose, after grade_frames has filled the result; evidence_attach (evidence.h) adds pictures.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

// Fills the causes of failed checks and the lab's summary. `student` has the submission's folder, jail and
// context. With `swap` parts of ours are put into the submission to find the part with the fault, which needs
// our solutions and takes up to some 1.5 s; without, or where there are no solutions, the tasks are told that
// the failed checks have in common. False with a message when one of our own workers fails.
bool diagnose(LabResult *result, Exam *exam, const WorkerClient *student, bool swap);
