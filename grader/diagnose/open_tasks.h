// Which tasks of a submission are still to do, as its text tells.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

// By rubric_task_index.
typedef struct OpenTasks {
    bool marked[EXAM_MAX_TASKS]; // its TODO is in the file
    bool open[EXAM_MAX_TASKS];   // and what follows the TODO is as it was handed out, or its check shows no
                                 // effect
} OpenTasks;

// Reads the rubric's files in `folder`; what cannot be read has no open tasks.
void open_tasks_find(OpenTasks *tasks, const LabResult *result, Exam *exam, const char *folder);
