// The sentences of a diagnosis, each in one function.
#include "diagnose/wording.h"

#include "scene/check.h"

#include <stdio.h>
#include <string.h>

static void add_part(char *text, size_t size, const FaultPart *part) {
    if (part->whole)
        check_append(text, size, "in %s", part->file);
    else if (!part->function[0])
        check_append(text, size, "in %s, outside of its functions", part->file);
    else
        check_append(text, size, "in `%s` (%s)", part->function, part->file);
    if (part->helpers[0])
        check_append(text, size, " or in what it calls (%s)", part->helpers);
}

void wording_place(char *text, size_t size, const Fault *fault) {
    text[0] = '\0';
    for (int i = 0; i < fault->count; i++) {
        check_append(text, size, "%s", i == 0 ? "" : fault->either ? " or " : " and ");
        add_part(text, size, &fault->parts[i]);
    }
}

// "task 7.5", "tasks 7.4 and 7.5"
static void add_tasks(char *text, size_t size, const Suspects *suspects, const Rubric *rubric) {
    check_append(text, size, suspects->count > 1 ? "tasks " : "task ");
    for (int i = 0; i < suspects->count; i++)
        check_append(text, size, "%s%s",
                     i == 0                    ? ""
                     : i < suspects->count - 1 ? ", "
                                               : " and ",
                     rubric->hints[suspects->tasks[i]].task);
}

// "with that as it was handed out, the rest draws right", "... in 3 of 5 failed checks"
static void add_reset_proof(char *text, size_t size, const Fault *fault) {
    check_append(text, size, "with %s as handed out, the rest draws as it should",
                 fault->either      ? fault->count > 2 ? "any of them" : "either"
                 : fault->count > 1 ? "them"
                                    : "it");
    if (fault->repaired < fault->failed)
        check_append(text, size, " in %d of %d failed checks, so this is not all", fault->repaired,
                     fault->failed);
}

// "all checks pass", "3 of 5 failed checks pass"
static void add_proof(char *text, size_t size, const Fault *fault) {
    if (fault->reset) {
        add_reset_proof(text, size, fault);
        return;
    }
    check_append(text, size, "with ours in %s place ", fault->count > 1 ? "their" : "its");
    if (fault->repaired == fault->failed)
        check_append(text, size, fault->failed > 1 ? "all of them pass" : "it passes");
    else
        check_append(text, size, "%d of %d failed checks pass%s", fault->repaired, fault->failed,
                     fault->stopped ? " (the time for the search was over then)" : ", so this is not all");
}

static bool has_tasks(const Fault *fault) {
    for (int i = 0; i < fault->count; i++)
        if (fault->parts[i].tasks[0])
            return true;
    return fault->count == 0;
}

static void add_hint(char *hint, size_t size, const LabResult *result, const Suspects *suspects,
                     const Rubric *rubric) {
    if (!has_tasks(&result->fault))
        check_append(hint, size, "No task is done there: compare it with the lab as it was handed out.");
    else if (suspects->count > 0) {
        const char *task = rubric->hints[suspects->tasks[0]].task, *text = rubric_hint(rubric, task, 0);
        check_append(hint, size, "Task %s: %s", task, text ? text : "");
    }
}

static void add_cause(char *cause, size_t size, const LabResult *result, const Suspects *suspects,
                      const Rubric *rubric) {
    const Fault *fault = &result->fault;
    char place[400];
    wording_place(place, sizeof place, fault);
    if (suspects->no_effect)
        check_append(cause, size, "task %s has no effect yet; ", suspects->no_effect);
    if (fault->count > 1 && !fault->either)
        check_append(cause, size, "there are faults %s", place);
    else if (fault->count > 0)
        check_append(cause, size, "%s fault is %s", fault->repaired == fault->failed ? "the" : "a", place);
    else if (suspects->count == 0)
        check_append(cause, size, "the picture differs");
    else {
        check_append(cause, size, suspects->certain ? "look at " : "look first at ");
        add_tasks(cause, size, suspects, rubric);
    }
}

void wording_cause(char *cause, size_t cause_size, char *hint, size_t hint_size, const LabResult *result,
                   const Suspects *suspects, const Rubric *rubric) {
    cause[0] = hint[0] = '\0';
    add_cause(cause, cause_size, result, suspects, rubric);
    add_hint(hint, hint_size, result, suspects, rubric);
}

void wording_names(char *text, size_t size, const Named *named, const Rubric *rubric) {
    text[0] = '\0';
    check_append(text, size, "%s", rubric->mistakes[named->first].name);
    if (named->second >= 0)
        check_append(text, size, ", or %s", rubric->mistakes[named->second].name);
    if (named->looks == NAMED_PLAIN)
        check_append(text, size, ", or something else there that leaves the picture in one colour");
    else if (named->looks == NAMED_NO_EDGES)
        check_append(text, size, ", or something else there that leaves all of it lit, or all dark");
    else if (named->looks == NAMED_NO_EFFECT)
        check_append(text, size, ", or something else there that takes the effect away");
}

const char *wording_open(bool unsure) {
    return unsure ? "is not done, or has no effect yet" : "is not done";
}

void wording_next(LabResult *result, const char *task, const char *open) {
    result->advice[0] = '\0';
    snprintf(result->summary, sizeof result->summary, "task %s is next: it %s", task, open);
}

void wording_summary(LabResult *result, const char *mistake, const Suspects *suspects, const Rubric *rubric) {
    char *text = result->summary, place[400];
    const size_t size = sizeof result->summary;
    text[0] = result->advice[0] = '\0';
    wording_place(place, sizeof place, &result->fault);
    if (mistake)
        check_append(text, size, "%s", mistake);
    else
        add_cause(text, size, result, suspects, rubric);
    if (mistake && place[0])
        check_append(text, size, "; it is %s", place);
    if (result->fault.count > 0 && suspects->count > 0) {
        check_append(text, size, ", ");
        add_tasks(text, size, suspects, rubric);
    }
    if (result->fault.count > 0) {
        check_append(text, size, ": ");
        add_proof(text, size, &result->fault);
    } else if (mistake && suspects->count > 0) {
        check_append(text, size, ", ");
        add_tasks(text, size, suspects, rubric);
    } else if (suspects->count > 0)
        check_append(text, size,
                     suspects->certain ? ": just the failed checks need %s" : ": the failed checks need %s",
                     suspects->count > 1 ? "them" : "it");
    if (result->first_only)
        check_append(text, size,
                     "; it is right in the first frame, and wrong when another was drawn before: "
                     "something is kept from frame to frame");
    if (!mistake)
        add_hint(result->advice, sizeof result->advice, result, suspects, rubric);
}
