// What a run that goes on has to grade.
#pragma once

#include "class/origin.h"
#include "class/roster.h"

// Writes to `numbers` (room for the whole roster) the entries without a grade, and those whose submission,
// rubric or grader is another than when they were graded; `aloud`: that is said on standard output and in the
// log, with how many and why. Returns how many numbers there are.
int regrade_choose(int *numbers, const char *output, const Roster *roster, const RunSettings *plan,
                   const Origin *origin, bool aloud);
