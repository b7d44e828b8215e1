#include "diagnose/suspects.h"

#include "exam/exam_matrix.h"

#include <stdlib.h>
#include <string.h>

typedef struct Evidence {
    int misfits;   // checks that fail here and not so, or pass here and not so, and what else is known
    int own;       // checks in question that are about the task
    bool explains; // any of the checks in question
    bool certain;  // undone, the task fails just those
} Evidence;

typedef ExamEntry Entry(Exam *exam, int number, int c);

// Compares which checks fail with which of them fail so. False when ours cannot draw.
static bool compare(int *misfits, bool *explains, const LabResult *result, Exam *exam, const bool failed[],
                    Entry *entry, int number) {
    *misfits = 0;
    *explains = false;
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        if (!failed[c] && !check->passed)
            continue;
        const ExamEntry so = entry(exam, number, c);
        if (so == EXAM_UNKNOWN && exam->painters)
            return false;
        *misfits += so != EXAM_UNKNOWN && (so == EXAM_FAILS) != failed[c];
        *explains = *explains || (so == EXAM_FAILS && failed[c]);
    }
    return true;
}

static bool weigh(Evidence *evidence, int t, const LabResult *result, Exam *exam, const bool failed[]) {
    const Rubric *rubric = exam->rubric;
    const char *task = rubric->hints[t].task;
    int misfits;
    bool explains;
    *evidence = (Evidence){0};
    if (!compare(&evidence->misfits, &evidence->explains, result, exam, failed, exam_without_task, t))
        return false;
    evidence->certain = evidence->explains && evidence->misfits == 0;
    for (int m = 0; m < rubric->mistake_count && !evidence->certain; m++) {
        if (!rubric->mistakes[m].task || strcmp(rubric->mistakes[m].task, task) != 0)
            continue;
        if (!compare(&misfits, &explains, result, exam, failed, exam_with_mistake, m))
            return false;
        if (explains && (misfits < evidence->misfits || !evidence->explains))
            evidence->misfits = misfits;
        evidence->explains = evidence->explains || explains;
    }
    for (int c = 0; c < result->check_count; c++)
        evidence->own += failed[c] && strcmp(result->checks[c].check->task, task) == 0;
    return true;
}

static void insert(Suspects *suspects, Evidence *sorted, int t, const Evidence *evidence) {
    int i = suspects->count++;
    for (; i > 0 && (evidence->misfits < sorted[i - 1].misfits ||
                     (evidence->misfits == sorted[i - 1].misfits && evidence->own > sorted[i - 1].own));
         i--) {
        suspects->tasks[i] = suspects->tasks[i - 1];
        sorted[i] = sorted[i - 1];
    }
    suspects->tasks[i] = t;
    sorted[i] = *evidence;
}

bool suspects_find(Suspects *suspects, const LabResult *result, Exam *exam, const bool failed[],
                   const Known *known) {
    Evidence sorted[EXAM_MAX_TASKS] = {0}, evidence;
    *suspects = (Suspects){0};
    for (int t = 0; t < exam->rubric->hint_count; t++) {
        if (!known->among[t])
            continue;
        if (!weigh(&evidence, t, result, exam, failed))
            return false;
        evidence.misfits += known->against[t];
        if (evidence.explains)
            insert(suspects, sorted, t, &evidence);
    }
    int equal = 0;
    while (equal < suspects->count && sorted[equal].misfits == sorted[0].misfits)
        equal++;
    suspects->count = equal;
    suspects->certain = equal > 0 && sorted[0].certain;
    return true;
}
