// Which tasks' answers lie in a part of a file, and in which of them a student's part reads otherwise.
#pragma once

#include "diagnose/mixed_lab.h"

// Marks, by rubric_task_index, the tasks whose answers lie in these bytes of our text of the file.
void part_tasks_mark(bool tasks[], const Rubric *rubric, const MixedFile *file, size_t begin, size_t end);

// The same for all that stands outside of functions.
void part_tasks_mark_outside(bool tasks[], const Rubric *rubric, const MixedFile *file);

// Leaves of these tasks only those in whose answers the hunks lie: what reads like ours is not the fault. All
// stay when that leaves none. True when a hunk lies where no answer stands, or nothing can be told.
bool part_tasks_narrow(bool tasks[], const Rubric *rubric, const MixedFile *file, const Hunks *hunks);
