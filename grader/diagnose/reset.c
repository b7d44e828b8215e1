// Draws the submission with one part after the other as it was handed out; the parts with which the rest
// draws right can have the fault, and the tasks that are done in them.
#include "diagnose/reset.h"

#include "compile/lab_folder.h"
#include "diagnose/mixed_lab.h"
#include "exam/exam_reset.h"
#include "exam/frame_score.h"
#include "scene/check.h"
#include "score/score.h"

#include <stdio.h>
#include <string.h>

// What a search may cost, in seconds of a usual machine: counted and not measured, so that the same
// submission gets the same answer. The clock ends it where the machine is much slower.
static const double BUDGET = 3, COST_OF_C = 0.16, COST_OF_SHADERS = 0.08, COST_OF_FRAME = 0.006, CLOCK = 45;

// Of the pixels that are wrong in the submission: so many may differ yet.
static const double REST = 0.05;

typedef struct Trial {
    bool tried;                    // and drawn, by theirs and by ours
    bool right[RUBRIC_MAX_CHECKS]; // the rest draws what it should
    int weight;                    // the largest is tried first
} Trial;

typedef struct ResetSearch {
    MixedLab lab;
    Exam *exam;
    const Parts *parts;
    const OpenTasks *open;
    Trial trials[EXAM_MAX_PARTS];
    int now; // the part that is tried
    double spent, began;
    bool stopped;
} ResetSearch;

// Where the submission has drawn nothing at all, what the part changes in ours stands for what is wrong.
static double count_wrong(const CheckResult *check, const Variant *variant, const Image *shown) {
    const Image *yours = &check->yours[check->worst];
    return (double)score_count(yours->rgba ? yours : shown, &variant->reference);
}

static bool is_like(const ResetSearch *search, int p, int c, const Image *picture, const FrameFacts *facts) {
    const CheckResult *check = &search->lab.result->checks[c];
    const LatePicture *late = &search->exam->resets[p][c][check->worst];
    const Variant *variant = &search->exam->variants[c][check->worst];
    const Image *shown = exam_shown(late, variant);
    return !frame_wrong_size(facts, &late->facts) && facts->refused == late->facts.refused &&
           (double)score_count(picture, shown) <= REST * count_wrong(check, variant, shown);
}

static void note_check(void *context, int c, const Image *picture, const FrameFacts *facts) {
    ResetSearch *search = context;
    Trial *trial = &search->trials[search->now];
    if (exam_reset(search->exam, search->now, c, search->lab.result->checks[c].worst))
        trial->right[c] = is_like(search, search->now, c, picture, facts);
    else
        trial->tried = false;
}

// The student has changed it, or left it with a task that is done by what the files say.
static bool may_have_fault(const ResetSearch *search, int p) {
    const Parts *parts = search->parts;
    const Functions *theirs = &search->lab.files[parts->list[p].file].theirs;
    int tasks = 0, open = 0;
    for (int t = 0; t < parts->rubric->hint_count; t++)
        if (parts_have_task(parts, p, parts->rubric->hints[t].task)) {
            tasks++;
            open += search->open->open[t];
        }
    return tasks > 0 ? open < tasks : !parts_same(parts, p, theirs);
}

static bool is_worth_trying(const ResetSearch *search, int p) {
    return parts_exist(search->parts, p, &search->lab.files[search->parts->list[p].file].theirs) &&
           may_have_fault(search, p);
}

// Tasks of checks that failed speak for a part, tasks of checks that passed against it.
static int weigh(const ResetSearch *search, int p) {
    const LabResult *result = search->lab.result;
    int weight = 0;
    for (int c = 0; c < result->check_count; c++)
        if (parts_have_task(search->parts, p, result->checks[c].check->task))
            weight += search->lab.failed[c] ? 2 : result->checks[c].passed ? -1 : 0;
    return weight;
}

// A part that is as it was handed out already: the submission's own pictures are its.
static void try_untouched(ResetSearch *search) {
    for (int c = 0; c < search->lab.result->check_count; c++) {
        const CheckResult *check = &search->lab.result->checks[c];
        if (search->lab.failed[c] && check->yours[check->worst].rgba)
            note_check(search, c, &check->yours[check->worst], &check->facts[check->worst]);
    }
}

static void try_part(ResetSearch *search, int p) {
    const LabPart *part = &search->parts->list[p];
    MixedFile *file = &search->lab.files[part->file];
    const MixedFile before = *file;
    search->now = p;
    search->trials[p].tried = true;
    if (parts_same(search->parts, p, &file->theirs)) {
        try_untouched(search);
        return;
    }
    if (part->whole)
        file->all_ours = true;
    else if (part->function[0])
        file->choice.names[file->choice.count++] = part->function;
    else
        file->choice.outside = true;
    search->spent += (lab_folder_is_c(file->name) ? COST_OF_C : COST_OF_SHADERS) +
                     COST_OF_FRAME * search->lab.failed_count;
    if (!mixed_lab_draw(&search->lab, note_check, search))
        search->trials[p].tried = false;
    *file = before;
}

static bool is_over(ResetSearch *search) {
    search->stopped = search->stopped || search->spent >= BUDGET || process_now() > search->began + CLOCK;
    return search->stopped;
}

static void try_parts(ResetSearch *search) {
    bool used[EXAM_MAX_PARTS] = {0};
    for (int p = 0; p < search->parts->count; p++) {
        used[p] = !is_worth_trying(search, p);
        search->trials[p].weight = weigh(search, p);
    }
    while (!is_over(search)) {
        int best = -1;
        for (int p = 0; p < search->parts->count; p++)
            if (!used[p] && (best < 0 || search->trials[p].weight > search->trials[best].weight))
                best = p;
        if (best < 0)
            return;
        used[best] = true;
        try_part(search, best);
    }
}

static bool is_right(const ResetSearch *search, int p, int c) {
    return search->trials[p].tried && search->trials[p].right[c];
}

// Does the rest draw right with p in all failed checks? Then p hides the fault, or has it.
static bool is_candidate(const ResetSearch *search, int p) {
    for (int c = 0; c < search->lab.result->check_count; c++)
        if (search->lab.failed[c] && !is_right(search, p, c))
            return false;
    return true;
}

// Does the submission pass the failed checks with p as it was handed out?
static bool repairs(ResetSearch *search, int p) {
    for (int c = 0; c < search->lab.result->check_count; c++) {
        const int n = search->lab.result->checks[c].worst;
        const Image *ours = search->lab.failed[c] ? exam_reset(search->exam, p, c, n) : NULL;
        if (ours && score_count(ours, &search->exam->variants[c][n].reference) > 0)
            return false;
    }
    return true;
}

static bool explains_with(const ResetSearch *search, int p, int q) {
    for (int c = 0; c < search->lab.result->check_count; c++)
        if (search->lab.failed[c] && !is_right(search, p, c) && !is_right(search, q, c))
            return false;
    return true;
}

// Where no part alone explains all: two faults that show in different checks, when just one pair does.
static void find_pair(ResetFound *found, const ResetSearch *search) {
    int pairs = 0, first = -1, second = -1;
    for (int p = 0; p < search->parts->count; p++)
        for (int q = p + 1; q < search->parts->count; q++)
            if (explains_with(search, p, q)) {
                pairs++;
                first = p;
                second = q;
            }
    found->both = pairs == 1;
    if (found->both)
        found->parts[first] = found->parts[second] = found->any = true;
}

// Ours has all tasks done: where the student's has not, another picture acquits nothing.
static bool any_open(const OpenTasks *tasks) {
    return memchr(tasks->open, true, sizeof tasks->open) != NULL;
}

static void find_candidates(ResetFound *found, ResetSearch *search) {
    bool proved = false;
    for (int p = 0; p < search->parts->count; p++)
        if (search->trials[p].tried && is_candidate(search, p)) {
            const bool proof = repairs(search, p);
            if (proof && !proved)
                memset(found->parts, 0, sizeof found->parts);
            found->parts[p] = proof || !proved;
            proved = proved || proof;
        }
    for (int p = 0; p < search->parts->count; p++) {
        found->any = found->any || found->parts[p];
        const bool acquitted = search->trials[p].tried && !any_open(search->open);
        found->unknown[p] = !proved && !acquitted && !found->parts[p] && may_have_fault(search, p);
    }
}

// In how many failed checks would it be by chance that another candidate hides a fault of p, too?
static int count_chances(const ResetFound *found, ResetSearch *search, int p) {
    int count = 0;
    for (int c = 0; c < search->lab.result->check_count; c++) {
        bool chance = false;
        for (int q = 0; q < search->parts->count && search->lab.failed[c]; q++)
            chance = chance || (q != p && found->parts[q] && exam_hidden(search->exam, q, p, c) == EXAM_SEEN);
        count += chance;
    }
    return count;
}

static void know_tasks(ResetFound *found, ResetSearch *search) {
    const Rubric *rubric = search->parts->rubric;
    found->known.placed = found->any && !any_open(search->open);
    for (int t = 0; t < rubric->hint_count; t++) {
        int fewest = RUBRIC_MAX_CHECKS;
        for (int p = 0; p < search->parts->count; p++) {
            if (!(found->parts[p] || found->unknown[p]) ||
                !parts_have_task(search->parts, p, rubric->hints[t].task))
                continue;
            const int chances = found->parts[p] && !found->both ? count_chances(found, search, p) : 0;
            found->known.among[t] = true;
            fewest = chances < fewest ? chances : fewest;
        }
        found->known.by_chance[t] = fewest < RUBRIC_MAX_CHECKS ? fewest : 0;
    }
}

// The failed checks of which there is a picture; all of them where nothing was drawn at all, as create()
// fails.
static void choose_checks(MixedLab *lab, const bool failed[]) {
    const LabResult *result = lab->result;
    bool any = false;
    for (int c = 0; c < result->check_count; c++)
        any = any || result->checks[c].yours[0].rgba;
    for (int c = 0; c < result->check_count; c++) {
        lab->failed[c] = failed[c] && (!any || result->checks[c].yours[0].rgba);
        lab->failed_count += lab->failed[c];
    }
}

bool reset_find(ResetFound *found, const LabResult *result, Exam *exam, const WorkerClient *student,
                const OpenTasks *tasks, const bool failed[]) {
    static ResetSearch search;
    *found = (ResetFound){0};
    const Parts *parts = exam_parts(exam);
    if (!parts) {
        check_clear();
        return false;
    }
    search = (ResetSearch){.exam = exam, .open = tasks, .parts = parts, .began = process_now()};
    const bool ok = mixed_lab_open(&search.lab, result, exam, student, NULL);
    choose_checks(&search.lab, failed);
    if (ok && search.lab.failed_count > 0) {
        try_parts(&search);
        find_candidates(found, &search);
        if (!found->any)
            find_pair(found, &search);
        know_tasks(found, &search);
    }
    found->failed = search.lab.failed_count;
    found->stopped = search.stopped;
    mixed_lab_close(&search.lab);
    check_clear(); // of versions of ours that cannot be built
    return ok;
}
