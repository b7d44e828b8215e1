// Where who handed it in must not learn the variants (a class, Gradescope), a lab has no say: whatever it
// prints, or answers beside its pixels, may tell of them.
#pragma once

#include "compile/rubric.h"
#include "diagnose/result.h"
#include "exam/worker_client.h"

// After a muted student's frames were drawn and scored: if it had something to say, it draws once more, in
// another worker and variants of a seed that everybody may know, and what it says there comes into the
// result: its message (in the place of the one we had to make up), warnings, and what it prints. The points
// stay. False with a message: no worker can be started.
bool hidden_rehearse(LabResult *result, const WorkerClient *student, const Rubric *rubric);
