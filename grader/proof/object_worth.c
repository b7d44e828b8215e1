// Draws the exam without each thing once; then a pool of processes tries the changes, each with all of them.
#include "proof/object_worth.h"

#include "base/pool.h"
#include "base/progress_bar.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>

enum { MUTANT_SECONDS = 600, TRIES = 2 };

typedef struct WorthSearch {
    LabChanges *changes;
    ObjectWorth *worths;
    Absence *absences; // of the worths
    int count;
    ProgressBar bar;
    bool broken;
} WorthSearch;

static void work(Outcome *outcome, void *context) {
    WorthSearch *search = context;
    outcome->done = trial_without(&search->changes->court, &search->changes->mutants.list[outcome->job],
                                  search->absences, search->count, outcome->reason);
    if (!outcome->done)
        snprintf(outcome->reason, sizeof outcome->reason, "%.300s", check_message());
}

static void finished(const Outcome *outcome, void *context) {
    WorthSearch *search = context;
    progress_bar_step(&search->bar, NULL, !outcome->done);
    for (int i = 0; outcome->done && i < search->count; i++)
        if (outcome->reason[i] == LOSS_KILL) {
            search->worths[i].killed++;
            search->worths[i].example = outcome->job;
        }
    if (outcome->done || search->broken)
        return;
    char text[CHANGE_TEXT];
    search->broken = true;
    lab_changes_describe(text, search->changes, outcome->job);
    check_fail("%s: %s", text, outcome->reason);
}

static bool run(WorthSearch *search, int processes) {
    const Pool pool = {processes, TRIES, MUTANT_SECONDS, search, work, finished};
    const int count = search->changes->mutants.count;
    int *jobs = calloc((size_t)count + 1, sizeof *jobs);
    INVARIANT(jobs);
    for (int i = 0; i < count; i++)
        jobs[i] = i;
    progress_bar_begin(&search->bar, stderr, search->changes->examiner.rubric.id, count, 0);
    bool ok = pool_run(&pool, jobs, count) && !search->broken;
    progress_bar_end(&search->bar);
    free(jobs);
    return ok;
}

bool object_worth_find(LabChanges *changes, ObjectWorth *worths, int count, uint64_t seed, int processes) {
    const GradeOptions options = {.seed = seed};
    Absence *absences = calloc(OBJECT_WORTH_MOST, sizeof *absences);
    WorthSearch search = {.changes = changes, .worths = worths, .absences = absences, .count = count};
    INVARIANT(absences && count <= OBJECT_WORTH_MOST && count < POOL_REASON);
    changes->court.exam = lab_exam_exam(&changes->examiner, &options);
    bool ok = changes->court.exam != NULL;
    for (int i = 0; ok && i < count; i++) {
        worths[i].example = -1;
        ok = absence_create(&absences[i], changes->court.exam, worths[i].scene, worths[i].thing);
        worths[i].unfit = ok && absences[i].unfit;
    }
    lab_exam_rest(&changes->examiner); // no process of the pool may share our worker
    ok = ok && (count == 0 || run(&search, processes));
    for (int i = 0; i < count; i++)
        absence_destroy(&absences[i]);
    free(absences);
    return ok;
}
