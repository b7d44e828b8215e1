// Which tasks can be at fault, as the checks tell that failed and that passed: no files of the student's are
// looked at.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

typedef struct Suspects {
    int tasks[EXAM_MAX_TASKS]; // by rubric_task_index, the most likely first
    int count;
    bool certain;          // undone, each fails just the checks in question
    const char *no_effect; // one of them is written, and its checks show the lab without it; NULL: none
} Suspects;

// What is known of the tasks, by rubric_task_index.
typedef struct Known {
    bool among[EXAM_MAX_TASKS];    // those in question
    int by_chance[EXAM_MAX_TASKS]; // checks in which another part hides a fault there but by chance
    bool placed;                   // the parts with the fault are known, and the tasks are those in them
} Known;

// Of the tasks in question those that fit best: of which the task undone, or a known mistake in it, fails the
// checks in `failed` and no others, but for the fewest; and with them those that fit nearly as well, since a
// fault that nobody knows yet may fail another check than those. That failed checks are about a task speaks
// for it. False with a message when ours cannot draw.
bool suspects_find(Suspects *suspects, const LabResult *result, Exam *exam, const bool failed[],
                   const Known *known);

// One more task, the last, unless it is there; -1: none.
void suspects_add(Suspects *suspects, int task);
