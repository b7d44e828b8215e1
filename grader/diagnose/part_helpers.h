// What a student's function calls that ours does not: functions of the student's own.
#pragma once

#include "diagnose/mixed_lab.h"

// Lists in part->helpers the student's own functions that the part's function calls, where the fault may be
// as well.
void part_helpers_list(FaultPart *part, const MixedFile *file);

// Marks the tasks that ours answers in functions that the student has not got: the helpers stand for them, or
// the part does when ours calls them.
void part_helpers_mark(bool tasks[], const Rubric *rubric, const MixedFile *file, const FaultPart *part);
