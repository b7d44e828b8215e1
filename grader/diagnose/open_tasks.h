// Which tasks of a submission are still to do, as its text tells.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>

// By rubric_task_index.
typedef struct OpenTasks {
    bool open[EXAM_MAX_TASKS];   // its TODO is in the file, and what belongs to it is as it was handed out
    bool unsure[EXAM_MAX_TASKS]; // its TODO is in the file, and other TODOs beside it are gone: then it is
                                 // open when its check shows no effect
} OpenTasks;

// Reads the rubric's files in `folder`; what cannot be read has no open tasks.
void open_tasks_find(OpenTasks *tasks, const LabResult *result, Exam *exam, const char *folder);

// The open ones as task_blocks.h takes them, "3.4 3.6"; "" for none.
void open_tasks_list(char *list, size_t size, const OpenTasks *tasks, const Rubric *rubric);
