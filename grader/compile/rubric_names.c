#include "compile/rubric_names.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// "3" or "3.M" in lab 03, M from 1, without zeros before it.
static bool is_task(const Rubric *rubric, const char *task) {
    char written[24];
    const char *dot = strchr(task, '.');
    const int lab = atoi(rubric->id), number = dot && strlen(dot) < 5 ? atoi(dot + 1) : 0;
    if (dot && (number < 1 || number >= EXAM_MAX_TASKS))
        return false;
    snprintf(written, sizeof written, dot ? "%d.%d" : "%d", lab, number);
    return strcmp(task, written) == 0;
}

bool rubric_names_task(const Rubric *rubric, const JsonPlace *place, const char *task) {
    const int lab = atoi(rubric->id);
    return is_task(rubric, task) ||
           json_fields_fail(
               place, "task",
               "\"%s\" is no task of lab %s; write \"%d.1\" to \"%d.%d\", or \"%d\" for the whole lab", task,
               rubric->id, lab, lab, EXAM_MAX_TASKS - 1, lab);
}

bool rubric_names_asked(const Rubric *rubric, const JsonPlace *place, const char *task) {
    for (int c = 0; c < rubric->check_count; c++)
        if (strcmp(rubric->checks[c].task, task) == 0)
            return true;
    return json_fields_fail(place, "task",
                            "no check of rubric.json is about task \"%s\"; write the task of a check", task);
}

bool rubric_names_file(const Rubric *rubric, const char *name) {
    for (int i = 0; i < rubric->file_count; i++)
        if (strcmp(rubric->files[i], name) == 0)
            return true;
    return false;
}
