// Lists the parts that differ from ours, tries the likely first, keeps those with which failed checks pass.
#include "diagnose/swap.h"

#include "diagnose/part_helpers.h"
#include "diagnose/part_tasks.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_CANDIDATES = 64 };

// What a search may cost, in seconds of a usual machine: counted and not measured, so that the same
// submission gets the same answer. The clock ends it where the machine is much slower.
static const double BUDGET = 1.5, COST_OF_C = 0.16, COST_OF_SHADERS = 0.08, COST_OF_FRAME = 0.006, CLOCK = 8;

typedef enum PartKind { PART_FUNCTION, PART_OUTSIDE, PART_FILE } PartKind;

typedef struct Candidate {
    PartKind kind;
    int file;
    const char *name, *called; // of a function in ours, in theirs
    bool tasks[EXAM_MAX_TASKS];
    double weight; // the largest comes first
    bool used;
} Candidate;

typedef struct SwapSearch {
    MixedLab lab;
    const Rubric *rubric;
    Candidate list[MAX_CANDIDATES];
    int count;
    double spent, began;
    bool stopped;
} SwapSearch;

// Tasks of checks that failed speak for a part, tasks of checks that passed against it; shaders are tried
// before C, which needs the compiler.
static void weigh(Candidate *candidate, const SwapSearch *search) {
    static const double of_kind[] = {[PART_FUNCTION] = 0, [PART_OUTSIDE] = -4, [PART_FILE] = -100};
    const LabResult *result = search->lab.result;
    const char *name = search->lab.files[candidate->file].name;
    bool first = true;
    candidate->weight += of_kind[candidate->kind] - (strchr(name, '.')[2] == '\0' ? 0.25 : 0);
    for (int c = 0; c < result->check_count; c++) {
        const int t = rubric_task_index(search->rubric, result->checks[c].check->task);
        const bool has = t >= 0 && candidate->tasks[t];
        if (search->lab.failed[c])
            candidate->weight += has ? first ? 3 : 1 : 0;
        else if (result->checks[c].passed)
            candidate->weight -= has ? 0.5 : 0;
        first = first && !search->lab.failed[c];
    }
}

static Candidate *add(SwapSearch *search, PartKind kind, int file, const char *name, const char *called) {
    static Candidate spare;
    Candidate *candidate = search->count < MAX_CANDIDATES ? &search->list[search->count++] : &spare;
    *candidate = (Candidate){.kind = kind, .file = file, .name = name, .called = called};
    return candidate;
}

// The only function of theirs that can be ours under another name; NULL: none, or several.
static const char *find_renamed(const MixedFile *file, const char *name) {
    const char *found = NULL;
    for (int i = 0; i < file->theirs.count; i++) {
        const char *other = file->theirs.list[i].name;
        if (functions_find(&file->ours, other) ||
            !functions_same_signature(&file->theirs, other, &file->ours, name))
            continue;
        if (found)
            return NULL;
        found = other;
    }
    return found;
}

static void add_function(SwapSearch *search, int file, const Function *ours) {
    const MixedFile *mixed = &search->lab.files[file];
    const char *called = NULL;
    if (functions_find(&mixed->ours, ours->name) != ours ||
        functions_same(&mixed->theirs, &mixed->ours, ours->name))
        return;
    if (!functions_find(&mixed->theirs, ours->name) && !(called = find_renamed(mixed, ours->name)))
        return;
    Candidate *candidate = add(search, PART_FUNCTION, file, ours->name, called);
    part_tasks_mark(candidate->tasks, search->rubric, mixed, ours->begin, ours->end);
}

// Parts that are the same in both are no candidates.
static void list_candidates(SwapSearch *search) {
    for (int i = 0; i < search->rubric->file_count; i++) {
        const MixedFile *file = &search->lab.files[i];
        const bool split = !file->theirs.whole && !file->ours.whole;
        const int before = search->count;
        for (int k = 0; split && k < file->ours.count; k++)
            add_function(search, i, &file->ours.list[k]);
        if (split && !functions_same_outside(&file->theirs, &file->ours))
            part_tasks_mark_outside(add(search, PART_OUTSIDE, i, NULL, NULL)->tasks, search->rubric, file);
        const bool same = split && search->count == before && file->theirs.count == file->ours.count;
        if (!same)
            part_tasks_mark(add(search, PART_FILE, i, NULL, NULL)->tasks, search->rubric, file, 0,
                            strlen(file->ours_text));
    }
    for (int i = 0; i < search->count; i++)
        weigh(&search->list[i], search);
}

static int by_weight(const void *a, const void *b) {
    const Candidate *x = a, *y = b;
    if (x->weight != y->weight)
        return x->weight < y->weight ? 1 : -1;
    return x->file != y->file ? x->file - y->file : (int)x->kind - (int)y->kind;
}

static void choose(MixedFile *file, const Candidate *candidate) {
    Choice *choice = &file->choice;
    if (candidate->kind == PART_FILE) {
        file->all_ours = true;
    } else if (candidate->kind == PART_OUTSIDE) {
        choice->outside = true;
    } else if (choice->count < FUNCTIONS_MAX) {
        choice->names[choice->count] = candidate->name;
        choice->called[choice->count++] = candidate->called;
    }
}

static int try_choice(SwapSearch *search, int file) {
    const char *name = search->lab.files[file].name;
    search->spent += strchr(name, '.')[2] == '\0' ? COST_OF_C : COST_OF_SHADERS;
    search->spent += COST_OF_FRAME * search->lab.failed_count;
    return mixed_lab_try(&search->lab);
}

// With the text outside of functions, too, when it does not fit the student's without.
static int try_candidate(SwapSearch *search, const Candidate *candidate) {
    MixedFile *file = &search->lab.files[candidate->file];
    const MixedFile before = *file;
    choose(file, candidate);
    int passing = try_choice(search, candidate->file);
    if (passing < 0 && candidate->kind == PART_FUNCTION && !file->choice.outside &&
        !functions_same_outside(&file->theirs, &file->ours)) {
        file->choice.outside = true;
        passing = try_choice(search, candidate->file);
    }
    *file = before;
    return passing;
}

static bool is_over(SwapSearch *search) {
    search->stopped = search->stopped || search->spent >= BUDGET || process_now() > search->began + CLOCK;
    return search->stopped;
}

// The part that makes more than `passing` checks pass, and most; a whole file only when no smaller part does.
// NULL: none. Sets *passing.
static Candidate *find_best(SwapSearch *search, int *passing) {
    Candidate *best = NULL;
    for (int i = 0; i < search->count && *passing < search->lab.failed_count && !is_over(search); i++) {
        Candidate *candidate = &search->list[i];
        if (candidate->kind == PART_FILE && best)
            break;
        if (candidate->used || search->lab.files[candidate->file].all_ours)
            continue;
        const int count = try_candidate(search, candidate);
        if (count > *passing) {
            *passing = count;
            best = candidate;
        }
    }
    return best;
}

static void find_hunks(FaultPart *part, const MixedFile *file) {
    const Function *ours = functions_find(&file->ours, part->ours),
                   *theirs = functions_find(&file->theirs, part->function);
    part->hunks.unknown = !ours || !theirs;
    if (ours && theirs)
        hunks_find(&part->hunks, (TextPart){file->text, theirs->begin, theirs->end},
                   (TextPart){file->ours_text, ours->begin, ours->end});
}

// A whole file stands for the parts of it that were found before.
static void forget_parts(Fault *fault, const char *file) {
    int count = 0;
    for (int i = 0; i < fault->count; i++)
        if (strcmp(fault->parts[i].file, file) != 0)
            fault->parts[count++] = fault->parts[i];
    fault->count = count;
}

static void note_part(Fault *fault, const SwapSearch *search, const Candidate *candidate) {
    if (candidate->kind == PART_FILE)
        forget_parts(fault, search->lab.files[candidate->file].name);
    FaultPart *part = &fault->parts[fault->count++];
    const MixedFile *file = &search->lab.files[candidate->file];
    bool tasks[EXAM_MAX_TASKS];
    int count = 0;
    memcpy(tasks, candidate->tasks, sizeof tasks);
    *part = (FaultPart){.file = file->name, .whole = candidate->kind == PART_FILE};
    if (candidate->kind == PART_FUNCTION) {
        snprintf(part->function, sizeof part->function, "%s",
                 candidate->called ? candidate->called : candidate->name);
        snprintf(part->ours, sizeof part->ours, "%s", candidate->name);
        part_helpers_list(part, file);
        find_hunks(part, file);
        part->given = part_tasks_narrow(tasks, search->rubric, file, &part->hunks);
        part_helpers_mark(tasks, search->rubric, file, part);
    }
    for (int t = 0; t < search->rubric->hint_count && count < FAULT_TASKS; t++)
        if (tasks[t])
            part->tasks[count++] = search->rubric->hints[t].task;
}

// Draws with these parts of the file as ours, but for one of them; -1: with all.
static int try_parts(SwapSearch *search, const MixedFile *before, Candidate *const parts[], int count,
                     int without) {
    MixedFile *file = &search->lab.files[parts[0]->file];
    *file = *before;
    for (int i = 0; i < count; i++)
        if (i != without)
            choose(file, parts[i]);
    return try_choice(search, parts[0]->file);
}

// Where no part of a file helps alone, several may together: all that differ, without those that are not
// needed. False when they are too many, or the time is over before that is known.
static bool choose_together(Fault *fault, SwapSearch *search, const Candidate *whole, int passing) {
    const MixedFile before = search->lab.files[whole->file];
    Candidate *parts[MAX_CANDIDATES];
    int count = 0;
    for (int i = 0; i < search->count; i++)
        if (search->list[i].file == whole->file && search->list[i].kind != PART_FILE && !search->list[i].used)
            parts[count++] = &search->list[i];
    bool found = count > 1 && try_parts(search, &before, parts, count, -1) >= passing;
    for (int i = count - 1; found && i >= 0; i--)
        if (!is_over(search) && try_parts(search, &before, parts, count, i) >= passing)
            parts[i] = parts[--count];
    found = found && !search->stopped && count > 0 && count <= FAULT_PARTS - fault->count;
    search->lab.files[whole->file] = before;
    for (int i = 0; found && i < count; i++) {
        parts[i]->used = true;
        choose(&search->lab.files[whole->file], parts[i]);
        note_part(fault, search, parts[i]);
    }
    return found;
}

static void search_parts(Fault *fault, SwapSearch *search) {
    int passing = 0;
    fault->failed = search->lab.failed_count;
    list_candidates(search);
    qsort(search->list, (size_t)search->count, sizeof search->list[0], by_weight);
    while (fault->count < FAULT_PARTS && passing < fault->failed) {
        Candidate *best = find_best(search, &passing);
        if (!best)
            break;
        best->used = true;
        if (best->kind == PART_FILE && choose_together(fault, search, best, passing))
            continue;
        choose(&search->lab.files[best->file], best);
        note_part(fault, search, best);
    }
    fault->repaired = passing;
    fault->stopped = search->stopped;
}

bool swap_find(Fault *fault, const LabResult *result, Exam *exam, const WorkerClient *student,
               const OpenTasks *tasks, const bool failed[]) {
    static SwapSearch search;
    char open[EXAM_MAX_TASKS * 8];
    *fault = (Fault){0};
    search = (SwapSearch){.rubric = exam->rubric, .began = process_now()};
    open_tasks_list(open, sizeof open, tasks, exam->rubric);
    const Solved solved = open[0] ? (Solved){SOLVED_WITHOUT, open} : (Solved){SOLVED_ALL, NULL};
    const bool ok = mixed_lab_open(&search.lab, result, exam, student, &solved);
    for (int c = 0; c < result->check_count; c++) {
        search.lab.failed[c] = failed[c];
        search.lab.failed_count += failed[c];
    }
    if (ok)
        search_parts(fault, &search);
    mixed_lab_close(&search.lab);
    return ok;
}
