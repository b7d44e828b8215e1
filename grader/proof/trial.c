// Writes the changed solution into a folder, builds it, and grades it as a submission until a check fails.
#include "proof/trial.h"

#include "compile/lab_folder.h"
#include "grade/grade_lab.h"
#include "grade/lab_verdict.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Wall time of one check. Ours take hundredths of it, so that also a busy machine calls only loops endless.
static const double CHECK_SECONDS = 10;

bool court_open(Court *court, const Rubric *rubric) {
    *court = (Court){.rubric = rubric};
    for (int i = 0; i < rubric->file_count; i++) {
        char path[FILES_PATH];
        files_join(path, rubric->folder, rubric->files[i]);
        court->texts[i] = files_read(path, DERIVE_MAX_FILE);
        if (!court->texts[i])
            return false;
    }
    return lab_folder_ours(court->solution, rubric, (Solved){SOLVED_ALL, NULL}, NULL);
}

void court_close(Court *court) {
    for (int i = 0; i < RUBRIC_MAX_FILES; i++)
        free(court->texts[i]);
    *court = (Court){0};
}

static bool write_sources(const Court *court, const Mutant *mutant, const char *folder) {
    bool ok = true;
    for (int i = 0; ok && i < court->rubric->file_count; i++) {
        char path[FILES_PATH];
        char *changed = i == mutant->file ? mutant_apply(mutant, court->texts[i]) : NULL;
        files_join(path, folder, court->rubric->files[i]);
        ok = files_write(path, changed ? changed : court->texts[i]);
        free(changed);
    }
    return ok;
}

static bool build(const Court *court, const char *sources, const char *folder, Verdict *verdict) {
    static char log[COMPILE_LOG];
    check_clear();
    if (!lab_folder_again(folder, court->solution, court->rubric, sources, NULL, log)) {
        *verdict = VERDICT_NOT_MADE;
        return log[0] != '\0'; // gcc's words: else it is our fault
    }
    return true;
}

static bool is_of(const Check *check, const Mutant *mutant) {
    return strcmp(check->task, mutant->task) == 0;
}

// The checks of the mutant's task, then all others, until one fails.
static bool passes_all(LabResult *result, const Court *court, const Mutant *mutant, WorkerClient *worker) {
    for (int others = 0; others < 2; others++)
        for (int c = 0; c < result->check_count; c++)
            if (is_of(result->checks[c].check, mutant) == !others) {
                worker_client_begin(worker);
                if (!grade_check(result, court->exam, worker, c) || result->message[0])
                    return false;
            }
    return true;
}

static Verdict judge(const LabResult *result, bool passes) {
    if (strstr(result->message, " does not compile:\n") || strstr(result->message, " do not link:\n"))
        return VERDICT_NOT_MADE;
    return passes ? VERDICT_SURVIVED : VERDICT_KILLED;
}

// Who draws the lab that was built into this folder.
static WorkerClient make_worker(const Court *court, const char *folder) {
    WorkerClient worker = {.trust = TRUST_OURS,
                           .context = court->exam->painters->context,
                           .quick_shaders = true,
                           .each_turn = true,
                           .seconds = CHECK_SECONDS};
    snprintf(worker.folder, sizeof worker.folder, "%s", folder);
    return worker;
}

static void examine(const Court *court, const Mutant *mutant, const char *folder, Verdict *verdict,
                    char told[TRIAL_TEXT]) {
    static LabResult result;
    static WorkerClient worker;
    worker = make_worker(court, folder);
    grade_begin(&result, court->rubric);
    const bool passes = passes_all(&result, court, mutant, &worker);
    *verdict = judge(&result, passes);
    snprintf(told, TRIAL_TEXT, "%.*s", TRIAL_TEXT - 1, result.warnings);
    worker_client_stop(&worker);
    result_destroy_lab(&result);
}

// Makes both folders and builds the lab with the change. False with a message: a fault of ours.
static bool make(const Court *court, const Mutant *mutant, char sources[FILES_PATH], char folder[FILES_PATH],
                 Verdict *verdict) {
    *verdict = VERDICT_OPEN;
    if (!files_make_temporary(sources))
        return false;
    if (!files_make_temporary(folder)) {
        files_remove(sources);
        return false;
    }
    return write_sources(court, mutant, sources) && build(court, sources, folder, verdict);
}

bool trial_run(const Court *court, const Mutant *mutant, Verdict *verdict, char told[TRIAL_TEXT]) {
    char sources[FILES_PATH] = "", folder[FILES_PATH] = "";
    told[0] = '\0';
    const bool ok = make(court, mutant, sources, folder, verdict);
    if (ok && *verdict == VERDICT_OPEN)
        examine(court, mutant, folder, verdict, told);
    files_remove(sources);
    files_remove(folder);
    return ok;
}

// Does the lab pass this check of this exam? Who crashes or takes too long does not, and is not *alive.
static bool passes_check(const Court *court, Exam *exam, WorkerClient *worker, int c, bool *alive) {
    static LabResult result;
    grade_begin(&result, court->rubric);
    worker_client_begin(worker);
    const bool passes = grade_check(&result, exam, worker, c);
    *alive = *alive && !result.message[0];
    result_destroy_lab(&result);
    return passes && *alive;
}

// The change fails this check: of the things that may matter, those stay without which it passes.
static bool lose(const Court *court, const Absence *absences, int count, int c, WorkerClient *worker,
                 char *losses) {
    bool alive = true, any = false;
    for (int i = 0; i < count; i++) {
        if (losses[i] == LOSS_KILL &&
            !(absence_concerns(&absences[i], c) && passes_check(court, absences[i].exam, worker, c, &alive)))
            losses[i] = LOSS_NONE;
        any = any || losses[i] == LOSS_KILL;
    }
    return any;
}

// The checks of the change's task first, as passes_all has it.
static void examine_without(const Court *court, const Mutant *mutant, const Absence *absences, int count,
                            WorkerClient *worker, char *losses) {
    bool alive = true, any = count > 0, killed = false;
    memset(losses, LOSS_KILL, (size_t)count);
    for (int others = 0; others < 2; others++)
        for (int c = 0; any && alive && c < court->rubric->check_count; c++)
            if (is_of(&court->rubric->checks[c], mutant) == !others &&
                !passes_check(court, court->exam, worker, c, &alive)) {
                killed = true;
                any = alive && lose(court, absences, count, c, worker, losses);
            }
    if (!any || !alive || !killed)
        memset(losses, LOSS_NONE, (size_t)count);
}

bool trial_without(const Court *court, const Mutant *mutant, const Absence *absences, int count,
                   char *losses) {
    static WorkerClient worker;
    char sources[FILES_PATH] = "", folder[FILES_PATH] = "";
    Verdict verdict;
    memset(losses, LOSS_NONE, (size_t)count);
    losses[count] = '\0';
    const bool ok = make(court, mutant, sources, folder, &verdict);
    if (ok && verdict == VERDICT_OPEN) {
        worker = make_worker(court, folder);
        examine_without(court, mutant, absences, count, &worker, losses);
        worker_client_stop(&worker);
    }
    files_remove(sources);
    files_remove(folder);
    return ok;
}
