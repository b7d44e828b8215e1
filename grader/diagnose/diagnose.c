#include "diagnose/diagnose.h"

#include "scene/check.h"
#include "score/error_kind.h"
#include "score/score.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A picture belongs to a mistake when it is this much nearer to the mistake's picture than to the reference.
static const double NEAR = 0.2;

// What another size of a stage, or a refused call, is worth beside a distance of pictures (0 to 255).
static const double FACT_DISTANCE = 64;

// Sums of distances over the frames of a check.
typedef struct Distances {
    double to_reference;
    double to_mistake[EXAM_MAX_MISTAKES];
} Distances;

static void name_cause(CheckResult *check, const char *mistake, const char *kind, const char *hint) {
    check->has_cause = true;
    snprintf(check->kind, sizeof check->kind, "%s", kind);
    snprintf(check->mistake, sizeof check->mistake, "%s", mistake);
    snprintf(check->hint, sizeof check->hint, "%s", hint ? hint : "");
}

// Of a frame of the student's from one of ours, in pixels and in what it tells beside them.
static double distance_to(const CheckResult *check, int n, const Image *ours, const FrameFacts *facts) {
    double distance = score_rmse(&check->yours[n], ours);
    distance += result_wrong_size(&check->facts[n], facts) ? FACT_DISTANCE : 0;
    return distance + (check->facts[n].refused != facts->refused ? FACT_DISTANCE : 0);
}

static void measure_ours(Distances *distances, const CheckResult *check, const Variant *variants) {
    *distances = (Distances){0};
    for (int n = 0; n < check->check->variants; n++) {
        distances->to_reference += distance_to(check, n, &variants[n].reference, &variants[n].facts);
    }
}

static bool measure_mistake(Distances *distances, int m, const LabResult *result, int c, Exam *exam) {
    for (int n = 0; n < result->checks[c].check->variants; n++) {
        const Image *theirs = exam_mistake(exam, m, c, n);
        if (!theirs)
            return false;
        distances->to_mistake[m] +=
            distance_to(&result->checks[c], n, theirs, &exam->mistakes[m][c][n].facts);
    }
    return true;
}

static bool wants_cause(const CheckResult *check) {
    return !check->passed && check->yours[0].rgba;
}

// The mistake that explains every failed check, or -1.
static int find_common(const LabResult *result, const Distances *distances, int mistakes) {
    int best = -1;
    double nearest = INFINITY;
    for (int m = 0; m < mistakes; m++) {
        double sum = 0;
        for (int c = 0; c < result->check_count; c++)
            if (wants_cause(&result->checks[c])) {
                bool near = distances[c].to_mistake[m] <= NEAR * distances[c].to_reference;
                sum += near ? distances[c].to_mistake[m] : INFINITY;
            }
        if (sum < nearest) {
            nearest = sum;
            best = m;
        }
    }
    return best;
}

// The mistake nearest in this check; among equals one of the check's own task. -1 when none is near.
static int find_own(const Check *check, const Distances *distances, const Rubric *rubric) {
    int best = -1;
    double nearest = NEAR * distances->to_reference;
    for (int m = 0; m < rubric->mistake_count; m++) {
        bool own = rubric->mistakes[m].task && strcmp(rubric->mistakes[m].task, check->task) == 0;
        double distance = distances->to_mistake[m] - (own ? 1e-6 : 0);
        if (distance < nearest) {
            nearest = distance;
            best = m;
        }
    }
    return best;
}

// When the picture is that of a lab solved only up to some task: the task after it. Else NULL.
static const char *next_task(const CheckResult *check, int c, Exam *exam) {
    for (int t = 1; rubric_task(exam->rubric, t + 1); t++) {
        const Image *theirs = exam_partial(exam, t, c, check->worst);
        if (theirs &&
            distance_to(check, check->worst, theirs, &exam->partials[t][c][check->worst].facts) == 0)
            return rubric_task(exam->rubric, t + 1);
    }
    return NULL;
}

// Does the lab, solved up to the task with number t (0: the skeleton), draw just what the student's draws, in
// every check?
static bool is_solved_to(int t, const LabResult *result, Exam *exam) {
    bool same = true;
    for (int c = 0; same && c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        const Image *theirs =
            t > 0 ? exam_partial(exam, t, c, check->worst) : &exam->variants[c][check->worst].skeleton;
        const FrameFacts facts = t > 0 ? exam->partials[t][c][check->worst].facts : (FrameFacts){0};
        same = theirs && distance_to(check, check->worst, theirs, &facts) == 0;
    }
    return same;
}

// Where a student who works in order stands: some task of first to last is not done, and they show only
// together. No such place: first is 0.
typedef struct Open {
    int first, last;
} Open;

static Open find_open(const LabResult *result, Exam *exam) {
    Open open = {0};
    for (int n = 0; rubric_task(exam->rubric, n + 1); n++) {
        bool same = is_solved_to(n, result, exam);
        if (same && !open.first)
            open.first = n + 1;
        if (same)
            open.last = n + 1;
        else if (open.first)
            break;
    }
    return open;
}

static void name_open(CheckResult *check, Open open, const Rubric *rubric) {
    char text[256];
    const char *dot = strchr(check->check->task, '.');
    const bool later = dot && atoi(dot + 1) > open.last;
    const char *task = later ? check->check->task : rubric_task(rubric, open.first);
    if (later || open.first == open.last)
        snprintf(text, sizeof text, "task %s is not done", task);
    else
        snprintf(text, sizeof text, "tasks %s to %s show only together, and one of them is not done", task,
                 rubric_task(rubric, open.last));
    name_cause(check, text, text, rubric_hint(rubric, task, 0));
    check->undone = true;
    check->cause_task = task;
}

static void name_kind(CheckResult *check, int c, Exam *exam) {
    char text[256];
    const char *kind = text;
    const char *task = next_task(check, c, exam);
    if (task)
        snprintf(text, sizeof text, "task %s or one after it is not done", task);
    else
        kind = error_kind(text, sizeof text, &check->yours[check->worst],
                          &exam->variants[c][check->worst].reference);
    name_cause(check, text, kind, rubric_hint(exam->rubric, task ? task : check->check->task, 0));
    check->undone = task != NULL;
    check->cause_task = task;
}

static void name_size(CheckResult *check, const Variant *variant) {
    const FrameFacts *yours = &check->facts[check->worst], *ours = &variant->facts;
    const bool as_frame =
        ours->stage_width == variant->request.width && ours->stage_height == variant->request.height;
    char text[256];
    snprintf(text, sizeof text, "the texture \"%s\" is %d x %d, and here it has to be %d x %d",
             check->check->view, yours->stage_width, yours->stage_height, ours->stage_width,
             ours->stage_height);
    name_cause(check, text, "a texture of another size",
               as_frame ? "It has to be as large as the picture, whatever size that has: frame->width and "
                          "frame->height."
                        : "The size is not always the same. Where does create take it from, and does every "
                          "call that needs it take it from there?");
}

static void name_refusal(CheckResult *check) {
    static const char text[] = "the picture is right here, but OpenGL refused a call";
    name_cause(check, text, text,
               "A refused call changes nothing; some drivers do half of it all the same, and others draw "
               "another picture. The note says which call it was, and where.");
}

static void explain(CheckResult *check, int c, const Distances *distances, int common, Exam *exam) {
    const Rubric *rubric = exam->rubric;
    int own = common >= 0 ? common : find_own(check->check, distances, rubric);
    char text[256];
    Touch touch = result_touch(check, exam->variants[c]);
    if (common < 0 && touch != TOUCH_CHANGED) {
        bool alone = touch == TOUCH_TASK_MISSING;
        snprintf(text, sizeof text, "task %s%s is not done", check->check->task,
                 alone ? "" : " or one before it");
        name_cause(check, text, text, rubric_hint(rubric, check->check->task, 0));
        check->undone = true;
    } else if (own >= 0 && (common >= 0 || !error_kind_is_plain(&check->yours[check->worst]))) {
        name_cause(check, rubric->mistakes[own].name, rubric->mistakes[own].name, rubric->mistakes[own].hint);
        check->cause_task = rubric->mistakes[own].task;
    } else if (check->wrong_size) {
        name_size(check, &exam->variants[c][check->worst]);
    } else if (check->refused && check->error == 0) {
        name_refusal(check);
    } else {
        name_kind(check, c, exam);
    }
}

static bool measure_mistakes(Distances *distances, const LabResult *result, Exam *exam) {
    const Rubric *rubric = exam->rubric;
    INVARIANT(rubric->mistake_count <= EXAM_MAX_MISTAKES);
    for (int m = 0; m < rubric->mistake_count; m++)
        for (int c = 0; c < result->check_count; c++)
            if (wants_cause(&result->checks[c]) && !measure_mistake(&distances[c], m, result, c, exam))
                return false;
    return true;
}

bool diagnose(LabResult *result, Exam *exam) {
    static Distances distances[RUBRIC_MAX_CHECKS];
    bool wanted = false, touched = false;
    for (int c = 0; c < result->check_count; c++)
        if (wants_cause(&result->checks[c])) {
            measure_ours(&distances[c], &result->checks[c], exam->variants[c]);
            wanted = true;
            touched = touched || result_touch(&result->checks[c], exam->variants[c]) == TOUCH_CHANGED;
        }
    if (!wanted)
        return true;
    if (touched && !measure_mistakes(distances, result, exam))
        return false;
    int common = touched ? find_common(result, distances, exam->rubric->mistake_count) : -1;
    Open open = common < 0 ? find_open(result, exam) : (Open){0};
    for (int c = 0; c < result->check_count; c++)
        if (wants_cause(&result->checks[c]) && open.first)
            name_open(&result->checks[c], open, exam->rubric);
        else if (wants_cause(&result->checks[c]))
            explain(&result->checks[c], c, &distances[c], common, exam);
    return true;
}
