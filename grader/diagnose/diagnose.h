// Says why a check failed: the task is untouched, or the nearest of the lab's known mistakes, or the kind of
// error.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

// Fills mistake and hint of each failed check of which frames were drawn. False with a message when one of
// our own workers fails.
bool diagnose(LabResult *result, Exam *exam);
