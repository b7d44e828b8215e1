#include "diagnose/describe.h"

#include "diagnose/error_view.h"
#include "score/error_kind.h"

#include <stdio.h>
#include <string.h>

static void describe_size(CheckResult *check, const Variant *variant) {
    const FrameFacts *yours = &check->facts[check->worst], *ours = &variant->facts;
    snprintf(check->seen, sizeof check->seen, "the texture \"%s\" is %d x %d, and here it has to be %d x %d",
             check->check->view, yours->stage_width, yours->stage_height, ours->stage_width,
             ours->stage_height);
}

static bool is_suspect(const Suspects *suspects, int t) {
    for (int i = 0; i < suspects->count; i++)
        if (suspects->tasks[i] == t)
            return true;
    return false;
}

void describe_check(CheckResult *check, int c, const Exam *exam, const Suspects *suspects) {
    const int own = rubric_task_index(exam->rubric, check->check->task);
    if (!check->yours[check->worst].rgba)
        return;
    const Touch touch = result_touch(check, exam->variants[c]);
    if (check->wrong_size)
        describe_size(check, &exam->variants[c][check->worst]);
    else if (check->refused && check->error == 0)
        snprintf(check->seen, sizeof check->seen, "the picture is right here, but OpenGL refused a call");
    else if (touch == TOUCH_TASK_MISSING && is_suspect(suspects, own))
        snprintf(check->seen, sizeof check->seen, "your task %s has no effect here yet", check->check->task);
    else if (touch == TOUCH_AS_SKELETON)
        snprintf(check->seen, sizeof check->seen, "the picture is that of the lab as it was handed out");
    else
        error_kind(check->seen, sizeof check->seen, &check->yours[check->worst],
                   &exam->variants[c][check->worst].reference, error_view_of(check->check, exam->rubric));
}

const char *describe_no_effect(const LabResult *result, const Exam *exam, const bool failed[],
                               const char *task) {
    const char *found = NULL;
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        if (!failed[c] || strcmp(check->check->task, task) != 0)
            continue;
        if (!check->yours[check->worst].rgba || check->wrong_size ||
            result_touch(check, exam->variants[c]) != TOUCH_TASK_MISSING)
            return NULL;
        found = task;
    }
    return found;
}
