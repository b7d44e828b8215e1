// Which tasks can be at fault, as the checks tell that failed and that passed: no files of the student's are
// looked at.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

typedef struct Suspects {
    int tasks[EXAM_MAX_TASKS]; // by rubric_task_index, the most likely first
    int count;
    bool certain; // each shows in all checks in question and in none that passed
} Suspects;

// Of the tasks in `among` (by index) those that show in all checks in `failed` and in the fewest that passed;
// when none shows in all, those that show in most. Where that
// is not certain and all failed checks are about one task, that one. A check's own tasks come first among
// equals. False with a message when ours cannot draw.
bool suspects_find(Suspects *suspects, const LabResult *result, Exam *exam, const bool failed[],
                   const bool among[]);
