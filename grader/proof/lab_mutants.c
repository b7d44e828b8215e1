// Lists the changes of a lab's sources, lets a pool of processes try those that are left seed after seed, and
// reports the ones that no seed noticed.
#include "proof/lab_mutants.h"

#include "base/pool.h"
#include "base/progress_bar.h"
#include "proof/equal.h"
#include "proof/lab_changes.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MUTANT_SECONDS = 600, TRIES = 2 };

typedef struct Fate {
    bool chosen; // by the settings
    Verdict verdict;
    const EqualChange *equal; // NULL: none
    char told[TRIAL_TEXT];
} Fate;

// All changes of one lab.
typedef struct Round {
    LabChanges all;
    EqualList equal;
    Fate *fates; // of the mutants
    ProgressBar bar;
    bool broken;
} Round;

static void choose(Round *round, const char *only) {
    char text[CHANGE_TEXT];
    round->fates = calloc((size_t)round->all.mutants.count + 1, sizeof *round->fates);
    INVARIANT(round->fates);
    for (int i = 0; i < round->all.mutants.count; i++) {
        const int file = round->all.mutants.list[i].file;
        lab_changes_describe(text, &round->all, i);
        round->fates[i].chosen = !only || strstr(text, only);
        round->fates[i].equal = equal_find(&round->equal, round->all.examiner.rubric.files[file],
                                           round->all.court.texts[file], &round->all.mutants.list[i]);
    }
}

static bool open_round(Round *round, const char *id, const char *only) {
    *round = (Round){0};
    if (!lab_changes_open(&round->all, id) || !equal_load(&round->equal, &round->all.examiner.rubric))
        return false;
    choose(round, only);
    return true;
}

static void close_round(Round *round) {
    free(round->fates);
    equal_destroy(&round->equal);
    lab_changes_close(&round->all);
}

static void work(Outcome *outcome, void *context) {
    Round *round = context;
    Verdict verdict;
    outcome->done =
        trial_run(&round->all.court, &round->all.mutants.list[outcome->job], &verdict, outcome->reason);
    outcome->score = verdict;
    if (!outcome->done)
        snprintf(outcome->reason, sizeof outcome->reason, "%.300s", check_message());
}

static void finished(const Outcome *outcome, void *context) {
    Round *round = context;
    Fate *fate = &round->fates[outcome->job];
    progress_bar_step(&round->bar, NULL, !outcome->done);
    fate->verdict = (Verdict)outcome->score;
    snprintf(fate->told, sizeof fate->told, "%.*s", TRIAL_TEXT - 1, outcome->reason);
    if (outcome->done || round->broken)
        return;
    char text[CHANGE_TEXT];
    round->broken = true;
    lab_changes_describe(text, &round->all, outcome->job);
    check_fail("%s: %s", text, outcome->reason);
}

// The mutants that no check has noticed yet.
static int list_jobs(const Round *round, int *jobs) {
    int count = 0;
    for (int i = 0; i < round->all.mutants.count; i++) {
        const Verdict verdict = round->fates[i].verdict;
        if (round->fates[i].chosen && (verdict == VERDICT_OPEN || verdict == VERDICT_SURVIVED))
            jobs[count++] = i;
    }
    return count;
}

static bool run_seed(Round *round, int seed, const MutantSettings *settings) {
    const GradeOptions options = {.seed = (uint64_t)seed};
    const Pool pool = {settings->processes, TRIES, MUTANT_SECONDS, round, work, finished};
    int *jobs = calloc((size_t)round->all.mutants.count + 1, sizeof *jobs);
    INVARIANT(jobs);
    const int count = list_jobs(round, jobs);
    bool ok = true;
    if (count > 0) {
        round->all.court.exam = lab_exam_exam(&round->all.examiner, &options);
        lab_exam_rest(&round->all.examiner); // no process of the pool may share our worker
        progress_bar_begin(&round->bar, stderr, round->all.examiner.rubric.id, count, 0);
        ok = round->all.court.exam && pool_run(&pool, jobs, count) && !round->broken;
        progress_bar_end(&round->bar);
        lab_exam_forget(&round->all.examiner);
    }
    free(jobs);
    return ok;
}

static void print_survivor(const Round *round, int i) {
    const Mutant *mutant = &round->all.mutants.list[i];
    const char *text = round->all.court.texts[mutant->file], *line = text + mutant->begin;
    char about[CHANGE_TEXT];
    while (line > text && line[-1] != '\n')
        line--;
    line += strspn(line, " ");
    lab_changes_describe(about, &round->all, i);
    printf("survived: %s\n    %.*s\n", about, (int)strcspn(line, "\n"), line);
    if (round->fates[i].told[0])
        printf("    told: %s\n", round->fates[i].told);
}

static bool refuse_noticed(const Round *round, int i) {
    char text[CHANGE_TEXT];
    const Verdict verdict = round->fates[i].verdict;
    if (!round->fates[i].equal || (verdict != VERDICT_KILLED && verdict != VERDICT_NOT_MADE))
        return true;
    lab_changes_describe(text, &round->all, i);
    printf("refused: equal.json calls this equal in effect, but %s: %s\n",
           verdict == VERDICT_KILLED ? "a check notices it" : "it does not compile", text);
    return false;
}

static bool refuse_unmatched(const Round *round) {
    bool ok = true;
    for (int i = 0; i < round->equal.count; i++) {
        const EqualChange *change = &round->equal.changes[i];
        if (change->matched == 0)
            printf("refused: lab %s: equal.json names a change that there is not: %s: \"%s\" in \"%s\"\n",
                   round->all.examiner.rubric.id, change->file, change->from, change->line);
        ok = ok && change->matched > 0;
    }
    return ok;
}

static bool report(const Round *round) {
    int made = 0, compiled = 0, killed = 0, equal = 0, survived = 0;
    bool ok = refuse_unmatched(round);
    for (int i = 0; i < round->all.mutants.count; i++) {
        const Fate *fate = &round->fates[i];
        made += fate->chosen;
        compiled += fate->verdict == VERDICT_KILLED || fate->verdict == VERDICT_SURVIVED;
        killed += fate->verdict == VERDICT_KILLED;
        equal += fate->verdict == VERDICT_SURVIVED && fate->equal;
        survived += fate->verdict == VERDICT_SURVIVED && !fate->equal;
        ok = refuse_noticed(round, i) && ok;
        if (fate->verdict == VERDICT_SURVIVED && !fate->equal)
            print_survivor(round, i);
    }
    printf("| %s | %d | %d | %d | %d | %d | %.1f |\n", round->all.examiner.rubric.id, made, compiled, killed,
           equal, survived, compiled > 0 ? 100.0 * (killed + equal) / compiled : 100);
    fflush(stdout);
    return ok && survived == 0;
}

bool lab_mutants_run(const char *id, const MutantSettings *settings, bool *clean) {
    static Round round;
    bool ok = open_round(&round, id, settings->only);
    for (int seed = 1; ok && seed <= settings->seeds; seed++)
        ok = run_seed(&round, seed, settings);
    *clean = ok && report(&round);
    close_round(&round);
    return ok;
}

bool lab_mutants_list(const char *id, const char *only) {
    static Round round;
    char text[CHANGE_TEXT];
    const bool ok = open_round(&round, id, only);
    for (int i = 0; ok && i < round.all.mutants.count; i++)
        if (round.fates[i].chosen) {
            lab_changes_describe(text, &round.all, i);
            puts(text);
        }
    close_round(&round);
    return ok;
}
