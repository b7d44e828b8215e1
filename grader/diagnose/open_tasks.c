// Looks for the TODO of each task, and whether anything was written in its place.
#include "diagnose/open_tasks.h"

#include "base/files.h"
#include "compile/lab_folder.h"
#include "compile/tokens.h"
#include "diagnose/task_text.h"
#include "exam/handed_out.h"
#include "score/score.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS_AFTER = 3 }; // that a task in its place would push away

// Do the same words follow behind the lines of the two marks?
static bool same_after(const char *a, const char *b) {
    a += strcspn(a, "\n");
    b += strcspn(b, "\n");
    for (int i = 0; i < WORDS_AFTER; i++) {
        const Token x = tokens_next(&a), y = tokens_next(&b);
        if (x.kind != y.kind || !tokens_same(&x, &y))
            return false;
        if (x.kind == TOKEN_END)
            return true;
    }
    return true;
}

static bool stands_as_handed_out(const char *mark, const char *at, const char *skeleton) {
    for (const char *ours = strstr(skeleton, mark); ours; ours = strstr(ours + 1, mark))
        if (same_after(at, ours))
            return true;
    return false;
}

// As in the lab as it was handed out, or, where we have it, as in the lab with all tasks done but this one:
// what follows may be the place of another task. Where TODOs beside it are gone, a few words tell.
static TaskText compare(const char *text, const char *at, const char *mark, const char *skeleton,
                        const char *without) {
    const TaskText found = task_text_compare(text, at, mark, skeleton);
    if (found == TASK_TEXT_HANDED_OUT ||
        (without && task_text_compare(text, at, mark, without) == TASK_TEXT_HANDED_OUT))
        return TASK_TEXT_HANDED_OUT;
    if (found != TASK_TEXT_UNKNOWN)
        return found;
    if (stands_as_handed_out(mark, at, skeleton) || (without && stands_as_handed_out(mark, at, without)))
        return TASK_TEXT_HANDED_OUT;
    if (without && task_text_put_before(text, at, mark, without))
        return TASK_TEXT_WRITTEN;
    return found;
}

static TaskText read_mark(const char *text, const char *at, const char *mark, const Rubric *rubric, int file,
                          int t) {
    const Solved all_but = {SOLVED_ALL_BUT, rubric->hints[t].task};
    char *skeleton = handed_out_text(rubric, file);
    char *without = handed_out_alone() ? NULL : lab_folder_source(rubric, file, all_but);
    const TaskText found = skeleton ? compare(text, at, mark, skeleton, without) : TASK_TEXT_UNKNOWN;
    free(skeleton);
    free(without);
    return found;
}

static void find_in(OpenTasks *tasks, const Rubric *rubric, int file, const char *text) {
    for (int t = 0; t < rubric->hint_count && t < EXAM_MAX_TASKS; t++) {
        char mark[32];
        snprintf(mark, sizeof mark, "TODO(%s)", rubric->hints[t].task);
        for (const char *at = strstr(text, mark); at; at = strstr(at + 1, mark)) {
            const TaskText found = read_mark(text, at, mark, rubric, file, t);
            tasks->open[t] = tasks->open[t] || found == TASK_TEXT_HANDED_OUT;
            tasks->unsure[t] = tasks->unsure[t] || found == TASK_TEXT_UNKNOWN || found == TASK_TEXT_EITHER;
        }
    }
}

// Does the check show what our lab shows before its task is done, whichever of the tasks before it are?
static bool shows_no_effect(const LabResult *result, Exam *exam, int c) {
    const CheckResult *check = &result->checks[c];
    const Image *yours = &check->yours[check->worst];
    const char *dot = strchr(check->check->task, '.');
    if (!yours->rgba)
        return false;
    if (result_touch(check, exam->variants[c]) != TOUCH_CHANGED)
        return true;
    for (int n = 1; dot && n < atoi(dot + 1); n++) {
        const Image *ours = exam_partial(exam, n, c, check->worst);
        if (ours && score_rmse(yours, ours) == 0)
            return true;
    }
    return false;
}

// Does none of the task's checks that failed show anything of it, and is there one?
static bool shows_nowhere(const LabResult *result, Exam *exam, int t) {
    bool any = false;
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        if (check->passed || rubric_task_index(exam->rubric, check->check->task) != t)
            continue;
        if (!shows_no_effect(result, exam, c))
            return false;
        any = true;
    }
    return any;
}

void open_tasks_find(OpenTasks *tasks, const LabResult *result, Exam *exam, const char *folder) {
    const Rubric *rubric = exam->rubric;
    *tasks = (OpenTasks){0};
    for (int i = 0; i < rubric->file_count; i++) {
        char path[FILES_PATH];
        files_join(path, folder, rubric->files[i]);
        char *text = files_read(path, DERIVE_MAX_FILE);
        if (text)
            find_in(tasks, rubric, i, text);
        free(text);
    }
    for (int t = 0; t < EXAM_MAX_TASKS; t++)
        tasks->unsure[t] = tasks->unsure[t] && !tasks->open[t];
    for (int t = 0; t < rubric->hint_count && t < EXAM_MAX_TASKS; t++)
        tasks->open[t] = tasks->open[t] || (tasks->unsure[t] && shows_nowhere(result, exam, t));
    for (int t = 0; t < rubric->hint_count && t < EXAM_MAX_TASKS; t++)
        if (result_task_passed(result, rubric, t)) // it is done, whatever its file looks like
            tasks->open[t] = tasks->unsure[t] = false;
    check_clear();
}

void open_tasks_list(char *list, size_t size, const OpenTasks *tasks, const Rubric *rubric) {
    list[0] = '\0';
    for (int t = 0; t < rubric->hint_count; t++)
        if (tasks->open[t])
            check_append(list, size, "%s%s", list[0] ? " " : "", rubric->hints[t].task);
}
