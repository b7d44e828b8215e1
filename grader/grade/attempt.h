// A seed of its own for one attempt, so that nothing that is seen of it helps the next.
#pragma once

#include "exam/lab_exam.h"
#include "intake/submission.h"

#include <stdint.h>

// The seed of a submission in a class with this secret seed: made from what it holds of these labs' files, so
// that the same files get the same seed wherever, whenever and however packed they are graded. Without the
// secret nobody can tell it, or make other files that get the same.
uint64_t attempt_seed(uint64_t secret, const Submission *submission, const LabExam *examiners, int count);
