// What the frames of one check are worth.
#pragma once

#include "diagnose/result.h"
#include "exam/exam.h"

// Scores the check's frames against those of the solution, the worst variant counts, and, where they fail,
// against those of each alternative that is "also right". Fills in share, error, worst, passed and what the
// frames tell beside their pixels.
void score_check(CheckResult *check, Exam *exam, int c);
