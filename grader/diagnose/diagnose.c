// The order of a diagnosis: what is not done is set apart, then the part with the fault, the tasks that can
// be at fault, a known mistake, and last what the pictures show. grader/diagnose/README.md gives the reasons.
#include "diagnose/diagnose.h"

#include "compile/lab_folder.h"
#include "diagnose/describe.h"
#include "diagnose/reset.h"
#include "diagnose/swap.h"
#include "diagnose/first_frame.h"
#include "diagnose/wording.h"
#include "exam/exam_matrix.h"
#include "scene/check.h"
#include "score/soft_kind.h"
#include "score/whole_kind.h"

#include <stdio.h>
#include <string.h>

typedef struct Diagnosis {
    LabResult *result;
    Exam *exam;
    OpenTasks open;
    bool failed[RUBRIC_MAX_CHECKS]; // for another reason than a task that is not done
    bool any_failed;
    const char *next; // the first task that is not done and explains a failed check; NULL: none
    Suspects suspects;
    Named named;
} Diagnosis;

static void name_cause(CheckResult *check, const char *mistake, const char *hint) {
    check->has_cause = true;
    snprintf(check->mistake, sizeof check->mistake, "%s", mistake);
    snprintf(check->kind, sizeof check->kind, "%s", mistake);
    snprintf(check->hint, sizeof check->hint, "%s", hint ? hint : "");
}

// The open task that explains why check c failed: its own, or the first that it needs. -1: none. Whether its
// own is open may be unsure, and one that it needs the reason why it shows no effect.
static int find_open(const Diagnosis *this, int c) {
    const Rubric *rubric = this->exam->rubric;
    const int own = rubric_task_index(rubric, this->result->checks[c].check->task);
    const bool is_open = own >= 0 && this->open.open[own];
    if (is_open && !this->open.unsure[own])
        return own;
    for (int t = 0; t < rubric->hint_count; t++)
        if (this->open.open[t] && exam_without_task(this->exam, t, c) == EXAM_FAILS)
            return t;
    return is_open ? own : -1;
}

static void name_open(Diagnosis *this, int c, int t) {
    CheckResult *check = &this->result->checks[c];
    const Rubric *rubric = this->exam->rubric;
    const char *task = rubric->hints[t].task;
    char text[64];
    snprintf(text, sizeof text, "task %s %s", task, wording_open(this->open.unsure[t]));
    name_cause(check, text, rubric_hint(rubric, task, 0));
    check->undone = true;
    check->cause_task = task;
    if (!check->check->optional &&
        (!this->next || rubric_task_index(rubric, task) < rubric_task_index(rubric, this->next)))
        this->next = task;
}

// Sets apart what is not done from what is wrong.
static void sort_checks(Diagnosis *this) {
    LabResult *result = this->result;
    for (int c = 0; c < result->check_count; c++) {
        CheckResult *check = &result->checks[c];
        if (check->passed)
            continue;
        const int open = find_open(this, c);
        if (open >= 0 && check->yours[0].rgba)
            name_open(this, c, open);
        else if (open < 0)
            this->failed[c] = this->any_failed = true;
    }
}

// The tasks that are done in the parts with the fault.
static void know_fault(Known *known, const Fault *fault, const Rubric *rubric) {
    for (int i = 0; i < fault->count; i++)
        for (int k = 0; k < FAULT_TASKS && fault->parts[i].tasks[k]; k++)
            known->among[rubric_task_index(rubric, fault->parts[i].tasks[k])] = true;
}

static bool find_suspects(Diagnosis *this, const Known *known) {
    return suspects_find(&this->suspects, this->result, this->exam, this->failed, known);
}

static void know_all(Known *known, const Diagnosis *this) {
    for (int t = 0; t < this->exam->rubric->hint_count; t++)
        known->among[t] = !this->open.open[t];
}

// Has what was handed out changed in each part with the fault?
static bool given_changed(const Fault *fault) {
    for (int i = 0; i < fault->count; i++)
        if (fault->parts[i].function[0] && !fault->parts[i].given)
            return false;
    return true;
}

// Only what was handed out has changed in the part with the fault, and its tasks are right.
static bool fault_is_given(const Diagnosis *this) {
    for (int i = 0; i < this->suspects.count; i++)
        if (!result_task_passed(this->result, this->exam->rubric, this->suspects.tasks[i]))
            return false;
    return this->suspects.count > 0 && this->result->fault.count > 0 && given_changed(&this->result->fault);
}

// Random numbers are given, so that no task holds them. Where only the noise is another, the check tells
// whose task needs those numbers.
static void suspect_noise(Diagnosis *this) {
    const Rubric *rubric = this->exam->rubric;
    for (int c = 0; c < this->result->check_count; c++) {
        const CheckResult *check = &this->result->checks[c];
        const int own = rubric_task_index(rubric, check->check->task);
        const Image *yours = &check->yours[check->worst];
        const Image *reference = &this->exam->variants[c][check->worst].reference;
        if (this->failed[c] && own >= 0 && yours->rgba && !check->wrong_size &&
            !soft_kind(yours, reference, true) && average_kind(yours, reference)) {
            this->suspects = (Suspects){.tasks = {own}, .count = 1};
            return;
        }
    }
}

// Else the failed checks tell which task needs what has changed.
static bool suspect_by_checks(Diagnosis *this) {
    Known known = {0};
    for (int c = 0; c < this->result->check_count; c++) {
        const int own = rubric_task_index(this->exam->rubric, this->result->checks[c].check->task);
        if (this->failed[c] && own >= 0)
            known.among[own] = !this->open.open[own];
    }
    return find_suspects(this, &known);
}

static bool find_by_swap(Diagnosis *this, const WorkerClient *student) {
    Known known = {0};
    LabResult *result = this->result;
    if (!swap_find(&result->fault, result, this->exam, student, &this->open, this->failed))
        return false;
    known.placed = result->fault.count > 0;
    if (known.placed)
        know_fault(&known, &result->fault, this->exam->rubric);
    else
        know_all(&known, this);
    if (!find_suspects(this, &known))
        return false;
    if (fault_is_given(this))
        suspect_noise(this);
    return !fault_is_given(this) || suspect_by_checks(this);
}

static bool find_by_reset(Diagnosis *this, const WorkerClient *student, ResetFound *found) {
    LabResult *result = this->result;
    bool any = false;
    if (!reset_find(found, result, this->exam, student, &this->open, this->failed))
        return false;
    for (int t = 0; t < EXAM_MAX_TASKS; t++)
        any = any || found->known.among[t];
    if (!any && !found->any)
        know_all(&found->known, this);
    const bool ok = find_suspects(this, &found->known), none = found->any && this->suspects.count == 0;
    for (int t = 0; ok && none && t < this->exam->rubric->hint_count; t++) // what is done does too much
        if (found->known.among[t])
            suspects_add(&this->suspects, t);
    return ok;
}

static void name_failed(Diagnosis *this, const char *mistake, const char *hint) {
    const Rubric *rubric = this->exam->rubric;
    for (int c = 0; c < this->result->check_count; c++) {
        CheckResult *check = &this->result->checks[c];
        if (!this->failed[c])
            continue;
        if (check->has_cause && !check->yours[0].rgba) { // the worker was lost in it
            check_append(check->mistake, sizeof check->mistake, "; %s", mistake);
            snprintf(check->hint, sizeof check->hint, "%s", hint);
            continue;
        }
        name_cause(check, mistake, hint);
        if (this->named.first >= 0 && rubric->mistakes[this->named.first].task)
            check->cause_task = rubric->mistakes[this->named.first].task;
        else if (this->suspects.count > 0)
            check->cause_task = rubric->hints[this->suspects.tasks[0]].task;
        if (this->named.first < 0)
            describe_check(check, c, this->exam, &this->suspects);
    }
}

static void find_no_effect(Diagnosis *this) {
    Suspects *suspects = &this->suspects;
    for (int i = 0; i < suspects->count && !suspects->no_effect; i++)
        suspects->no_effect = describe_no_effect(this->result, this->exam, this->failed,
                                                 this->exam->rubric->hints[suspects->tasks[i]].task);
    if (suspects->no_effect && this->named.looks == NAMED_SHOWN)
        this->named.looks = NAMED_NO_EFFECT;
}

// A picture of one colour, or without any edge of a shadow, or without the task, has many causes. Where
// nobody has compared the words, a known mistake that draws it is an example and no name.
static bool is_example(const Diagnosis *this) {
    return this->named.first >= 0 && this->named.looks != NAMED_SHOWN && this->result->fault.reset &&
           this->result->fault.count > 0;
}

static void name_faults(Diagnosis *this) {
    char cause[256], hint[1500], example[160] = "";
    const Rubric *rubric = this->exam->rubric;
    find_no_effect(this);
    if (is_example(this)) {
        snprintf(example, sizeof example, "; one mistake that looks so: %s",
                 rubric->mistakes[this->named.first].name);
        this->named.first = -1;
    }
    const bool named = this->named.first >= 0;
    if (named) {
        wording_names(cause, sizeof cause, &this->named, rubric);
        snprintf(hint, sizeof hint, "%s", rubric->mistakes[this->named.first].hint);
    } else {
        wording_cause(cause, sizeof cause, hint, sizeof hint, this->result, &this->suspects, rubric);
        check_append(cause, sizeof cause, "%s", example);
    }
    name_failed(this, cause, hint);
    wording_summary(this->result, named ? cause : NULL, &this->suspects, rubric);
    if (named)
        snprintf(this->result->advice, sizeof this->result->advice, "%s", hint);
}

static bool find_mistake(Diagnosis *this, const ResetFound *found) {
    return catalogue_find(&this->named, this->result, this->exam, this->failed, found);
}

// The mistake's name says which task it is; the parts are then those of that task. Where many causes draw
// what the mistake draws, its task is one more.
static void narrow_to_named(Diagnosis *this) {
    const Rubric *rubric = this->exam->rubric;
    const int named[2] = {this->named.first, this->named.second};
    Suspects narrow = {.certain = this->suspects.certain};
    for (int i = 0; i < 2 && this->named.looks == NAMED_SHOWN; i++) {
        const char *task = named[i] >= 0 ? rubric->mistakes[named[i]].task : NULL;
        const int t = task ? rubric_task_index(rubric, task) : -1;
        if (t >= 0 && (i == 0 || t != narrow.tasks[0]))
            narrow.tasks[narrow.count++] = t;
    }
    if (narrow.count > 0)
        this->suspects = narrow;
    else if (named[0] >= 0 && rubric->mistakes[named[0]].task)
        suspects_add(&this->suspects, rubric_task_index(rubric, rubric->mistakes[named[0]].task));
}

static bool find_fault(Diagnosis *this, const WorkerClient *student, FaultSearch search) {
    static ResetFound found;
    Known known = {0};
    know_all(&known, this);
    if (search == FAULT_BY_PICTURES)
        return find_suspects(this, &known) && find_mistake(this, NULL);
    if (search == FAULT_BY_SWAP && this->exam->painters)
        return find_by_swap(this, student) && find_mistake(this, NULL);
    if (!find_by_reset(this, student, &found) || !find_mistake(this, &found))
        return false;
    if (this->named.many) // each of them is as likely, and nobody has compared the words
        this->named = (Named){.first = -1, .second = -1};
    find_no_effect(this);
    if (!found.both)
        narrow_to_named(this);
    reset_note(&this->result->fault, &found, &this->suspects, this->exam->parts);
    return true;
}

// Nothing is kept from one frame to the next in a shader: with ours in the place of the student's, all was
// right in later frames, too.
static bool lies_in_shaders(const Fault *fault) {
    bool shaders = !fault->reset && fault->count > 0 && fault->repaired == fault->failed;
    for (int i = 0; i < fault->count; i++)
        shaders = shaders && !lab_folder_is_c(fault->parts[i].file);
    return shaders;
}

bool diagnose(LabResult *result, Exam *exam, const WorkerClient *student, FaultSearch search) {
    static Diagnosis this;
    this = (Diagnosis){.result = result, .exam = exam, .named = {.first = -1, .second = -1}};
    open_tasks_find(&this.open, result, exam, student->folder);
    sort_checks(&this);
    if (!this.any_failed) {
        if (this.next)
            wording_next(result, this.next,
                         wording_open(this.open.unsure[rubric_task_index(exam->rubric, this.next)]));
        return true;
    }
    if (!find_fault(&this, student, search))
        return false;
    if (search != FAULT_BY_PICTURES && !lies_in_shaders(&result->fault))
        result->first_only = first_frame_find(result, exam, this.failed, student);
    name_faults(&this);
    return true;
}
