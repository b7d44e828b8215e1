// Compares which checks failed with those that fail without a task, and with its known mistakes.
#include "diagnose/suspects.h"

#include "exam/exam_matrix.h"

#include <limits.h>
#include <string.h>

// What speaks against a task. One that is not done shows in more checks than one that is done nearly right,
// so a check that passes says less against it than against a mistake.
enum {
    MISTAKE_MISFITS = 2,
    UNDONE_FAILS = 1,  // without the task the check fails, which passed here
    UNDONE_PASSES = 2, // ... the other way round; where the place is known, a fault may just do too much
    UNDONE_PASSES_PLACED = 1,
    BY_CHANCE = 2, // as many checks count one
    OWN_CHECK = 2, // speaks for it
    MOST_OWN = 2,  // checks that count so
    MARGIN = 1     // what is this near to the best may be it as well
};

typedef struct Evidence {
    int weight;    // what speaks against the task: the less, the more likely
    bool explains; // any of the checks in question
    bool certain;  // undone, the task fails just those
} Evidence;

typedef ExamEntry Entry(Exam *exam, int number, int c);

// What compare adds to the weight of a check that passes here and fails so, and of the other way round.
typedef struct Costs {
    int fails, passes;
} Costs;

// Weighs which checks fail here against which of them fail so; ends sooner where the weight comes to `most`.
// False when ours cannot draw.
static bool compare(Evidence *evidence, const LabResult *result, Exam *exam, const bool failed[],
                    Entry *entry, int number, Costs costs, int most) {
    *evidence = (Evidence){0};
    for (int c = 0; c < result->check_count && evidence->weight < most; c++) {
        if (!failed[c] && !result->checks[c].passed)
            continue;
        const ExamEntry so = entry(exam, number, c);
        if (so == EXAM_UNKNOWN && exam->painters)
            return false;
        evidence->weight += so == EXAM_FAILS && !failed[c]   ? costs.fails
                            : so == EXAM_PASSES && failed[c] ? costs.passes
                                                             : 0;
        evidence->explains = evidence->explains || (so == EXAM_FAILS && failed[c]);
    }
    evidence->certain = evidence->explains && evidence->weight == 0;
    return true;
}

// Takes the mistake's evidence where it fits better than what there is.
static void take_better(Evidence *evidence, const Evidence *mistake) {
    if (mistake->explains && (!evidence->explains || mistake->weight < evidence->weight)) {
        evidence->weight = mistake->weight;
        evidence->explains = true;
    }
}

static bool weigh(Evidence *evidence, int t, const LabResult *result, Exam *exam, const bool failed[],
                  const Known *known) {
    const Rubric *rubric = exam->rubric;
    const char *task = rubric->hints[t].task;
    const Costs undone = {UNDONE_FAILS, known->placed ? UNDONE_PASSES_PLACED : UNDONE_PASSES};
    if (!compare(evidence, result, exam, failed, exam_without_task, t, undone, INT_MAX))
        return false;
    for (int m = 0; m < rubric->mistake_count && !evidence->certain; m++) {
        Evidence mistake;
        const int most = evidence->explains ? evidence->weight : INT_MAX; // from here on it fits no better
        if (!rubric->mistakes[m].task || strcmp(rubric->mistakes[m].task, task) != 0)
            continue;
        if (!compare(&mistake, result, exam, failed, exam_with_mistake, m,
                     (Costs){MISTAKE_MISFITS, MISTAKE_MISFITS}, most))
            return false;
        take_better(evidence, &mistake);
    }
    int own = 0;
    for (int c = 0; c < result->check_count && own < MOST_OWN; c++)
        own += failed[c] && strcmp(result->checks[c].check->task, task) == 0;
    evidence->weight += (known->by_chance[t] + BY_CHANCE - 1) / BY_CHANCE - own * OWN_CHECK;
    return true;
}

static void insert(Suspects *suspects, Evidence *sorted, int t, const Evidence *evidence) {
    int i = suspects->count++;
    for (; i > 0 && evidence->weight < sorted[i - 1].weight; i--) {
        suspects->tasks[i] = suspects->tasks[i - 1];
        sorted[i] = sorted[i - 1];
    }
    suspects->tasks[i] = t;
    sorted[i] = *evidence;
}

void suspects_add(Suspects *suspects, int task) {
    for (int i = 0; i < suspects->count; i++)
        if (suspects->tasks[i] == task)
            return;
    if (task >= 0)
        suspects->tasks[suspects->count++] = task;
}

bool suspects_find(Suspects *suspects, const LabResult *result, Exam *exam, const bool failed[],
                   const Known *known) {
    Evidence sorted[EXAM_MAX_TASKS] = {0}, evidence;
    *suspects = (Suspects){0};
    for (int t = 0; t < exam->rubric->hint_count; t++) {
        if (!known->among[t])
            continue;
        if (!weigh(&evidence, t, result, exam, failed, known))
            return false;
        if (evidence.explains)
            insert(suspects, sorted, t, &evidence);
    }
    int near = 0;
    while (near < suspects->count && sorted[near].weight <= sorted[0].weight + MARGIN)
        near++;
    suspects->count = near;
    suspects->certain = near > 0;
    for (int i = 0; i < near; i++)
        suspects->certain = suspects->certain && sorted[i].certain;
    return true;
}
