#include "diagnose/suspects.h"

#include "exam/exam_matrix.h"

#include <string.h>

typedef struct Evidence {
    int for_it, against, own; // checks in question that fail without the task; that passed; that are about it
} Evidence;

static bool weigh(Evidence *evidence, int t, const LabResult *result, Exam *exam, const bool failed[]) {
    *evidence = (Evidence){0};
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        if (!failed[c] && !check->passed)
            continue;
        const ExamEntry entry = exam_without_task(exam, t, c);
        if (entry == EXAM_UNKNOWN && exam->painters)
            return false;
        evidence->for_it += entry == EXAM_FAILS && failed[c];
        evidence->against += entry == EXAM_FAILS && check->passed;
        evidence->own += failed[c] && strcmp(check->check->task, exam->rubric->hints[t].task) == 0;
    }
    return true;
}

// Is x the more likely one? What explains more first, then what less contradicts.
static bool is_before(const Evidence *x, const Evidence *y) {
    if (x->for_it != y->for_it)
        return x->for_it > y->for_it;
    if (x->against != y->against)
        return x->against < y->against;
    return x->own > y->own;
}

static bool is_equal(const Evidence *x, const Evidence *y) {
    return x->for_it == y->for_it && x->against == y->against;
}

static void insert(Suspects *suspects, Evidence *sorted, int t, const Evidence *evidence) {
    int i = suspects->count++;
    for (; i > 0 && is_before(evidence, &sorted[i - 1]); i--) {
        suspects->tasks[i] = suspects->tasks[i - 1];
        sorted[i] = sorted[i - 1];
    }
    suspects->tasks[i] = t;
    sorted[i] = *evidence;
}

// The task that all checks in question are about; -1: they are about several.
static int own_task(const LabResult *result, const Rubric *rubric, const bool failed[]) {
    int own = -1;
    for (int c = 0; c < result->check_count; c++) {
        const int t = failed[c] ? rubric_task_index(rubric, result->checks[c].check->task) : own;
        if (t < 0 && failed[c])
            return -1;
        if (own >= 0 && t != own)
            return -1;
        own = t;
    }
    return own;
}

bool suspects_find(Suspects *suspects, const LabResult *result, Exam *exam, const bool failed[],
                   const bool among[]) {
    Evidence sorted[EXAM_MAX_TASKS] = {0}, evidence;
    int wanted = 0;
    *suspects = (Suspects){0};
    for (int c = 0; c < result->check_count; c++)
        wanted += failed[c];
    for (int t = 0; t < exam->rubric->hint_count; t++) {
        if (!among[t])
            continue;
        if (!weigh(&evidence, t, result, exam, failed))
            return false;
        if (evidence.for_it > 0)
            insert(suspects, sorted, t, &evidence);
    }
    int equal = 0;
    while (equal < suspects->count && is_equal(&sorted[equal], &sorted[0]))
        equal++;
    suspects->count = equal;
    suspects->certain = equal > 0 && sorted[0].for_it == wanted && sorted[0].against == 0;
    const int own = own_task(result, exam->rubric, failed);
    if (!suspects->certain && own >= 0 && among[own])
        *suspects = (Suspects){.tasks = {own}, .count = 1};
    return true;
}
