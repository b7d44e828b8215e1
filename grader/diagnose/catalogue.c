// Measures, for each known mistake, how far the student's pictures are from the mistake's and from the
// reference, and keeps the one that fits all failed checks.
#include "diagnose/catalogue.h"

#include "compile/functions.h"
#include "compile/lab_folder.h"
#include "diagnose/error_view.h"
#include "exam/exam_matrix.h"
#include "exam/frame_score.h"
#include "scene/check.h"
#include "score/error_kind.h"
#include "score/score.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A picture belongs to a mistake when it is this much nearer to the mistake's picture than to the reference.
static const double NEAR = 0.2;
// Another mistake draws nearly the same when it is not farther than this much of the distance to the
// reference.
static const double ALIKE = 0.02;
// What another size of a stage, or a refused call, is worth beside a distance of pictures (0 to 255).
static const double FACT_DISTANCE = 64;

// Where our text of the file has the bytes: the function's name, "" outside of functions.
static void name_place(char name[FUNCTIONS_NAME], const char *text, const char *find) {
    static Functions functions;
    const char *at = strstr(text, find);
    name[0] = '\0';
    functions_split(&functions, text);
    for (int i = 0; at && i < functions.count; i++)
        if (at + strlen(find) > text + functions.list[i].begin && at < text + functions.list[i].end)
            memcpy(name, functions.list[i].name, FUNCTIONS_NAME);
}

// Does the edit of our text of the file change words of the function that the student's has otherwise, too?
static bool edit_meets(const Edit *edit, const char *text, const FaultPart *part) {
    static Functions ours, mistaken;
    static Hunks hunks;
    char *edited = part->hunks.count > 0 ? task_blocks_edit(text, edit) : NULL;
    if (!edited)
        return true;
    functions_split(&ours, text);
    functions_split(&mistaken, edited);
    const Function *a = functions_find(&mistaken, part->ours), *b = functions_find(&ours, part->ours);
    if (a && b)
        hunks_find(&hunks, (TextPart){edited, a->begin, a->end}, (TextPart){text, b->begin, b->end});
    const bool meets = !a || !b || hunks_meet(&hunks, &part->hunks);
    free(edited);
    return meets;
}

static bool edit_lies_in(const Edit *edit, const FaultPart *part, const Rubric *rubric) {
    char name[FUNCTIONS_NAME];
    if (strcmp(edit->file, part->file) != 0)
        return false;
    if (part->whole)
        return true;
    int file = 0;
    while (file < rubric->file_count - 1 && strcmp(rubric->files[file], edit->file) != 0)
        file++;
    char *text = lab_folder_source(rubric, file, (Solved){SOLVED_ALL, NULL});
    if (text)
        name_place(name, text, edit->find);
    const bool same = text && strcmp(name, part->ours) == 0 && edit_meets(edit, text, part);
    free(text);
    return same;
}

// Where we do not know how a mistake is made, its task tells.
static bool task_lies_in(const char *task, const FaultPart *part) {
    for (int k = 0; task && k < FAULT_TASKS && part->tasks[k]; k++)
        if (strcmp(part->tasks[k], task) == 0)
            return true;
    return false;
}

static bool lies_in(const Change *mistake, const FaultPart *part, const Rubric *rubric) {
    if (mistake->edit_count == 0)
        return !part->tasks[0] || task_lies_in(mistake->task, part);
    for (int e = 0; e < mistake->edit_count; e++)
        if (edit_lies_in(&mistake->edits[e], part, rubric))
            return true;
    return false;
}

static bool lies_in_fault(const Change *mistake, const Fault *fault, const Rubric *rubric) {
    for (int i = 0; i < fault->count; i++)
        if (lies_in(mistake, &fault->parts[i], rubric))
            return true;
    return fault->count == 0;
}

// In a part that can have the fault, or that could not be tried.
static bool lies_in_found(const Change *mistake, const ResetFound *found, const Exam *exam) {
    for (int p = 0; found && found->any && p < exam->parts->count; p++) {
        FaultPart part;
        if (!found->parts[p] && !found->unknown[p])
            continue;
        reset_part(&part, exam->parts, p);
        if (lies_in(mistake, &part, exam->rubric))
            return true;
    }
    return !found || !found->any;
}

// Of a frame of the student's from one of ours, in pixels and in what it tells beside them.
static double distance_to(const CheckResult *check, int n, const Image *ours, const FrameFacts *facts) {
    double distance = score_rmse(&check->yours[n], ours);
    distance += frame_wrong_size(&check->facts[n], facts) ? FACT_DISTANCE : 0;
    return distance + (check->facts[n].refused != facts->refused ? FACT_DISTANCE : 0);
}

// Sum of the distances to the mistake in one check; INFINITY when it is not near; below 0: ours cannot draw.
static double distance_in(const CheckResult *check, int m, int c, Exam *exam, double *to_reference) {
    double sum = 0, reference = 0;
    for (int n = 0; n < check->check->variants; n++)
        reference += distance_to(check, n, &exam->variants[c][n].reference, &exam->variants[c][n].facts);
    *to_reference += reference;
    for (int n = 0; n < check->check->variants && sum <= NEAR * reference; n++) {
        const Image *theirs = exam_mistake(exam, m, c, n);
        if (!theirs)
            return -1;
        sum += distance_to(check, n, theirs, &exam->mistakes[m][c][n].facts);
    }
    return sum <= NEAR * reference ? sum : INFINITY;
}

static bool shows_anything(const CheckResult *check) {
    return check->yours[check->worst].rgba && !error_kind_is_plain(&check->yours[check->worst]);
}

static bool lost_edges(const CheckResult *check, const Variant *variant, const Rubric *rubric) {
    return error_view_of(check->check, rubric) != ERROR_VIEW_VALUES &&
           error_kind_lost_edges(&check->yours[check->worst], &variant->reference, &variant->without);
}

static NamedLooks looks_of(const LabResult *result, const Exam *exam, const bool failed[]) {
    NamedLooks looks = NAMED_PLAIN;
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        if (!failed[c] || !shows_anything(check))
            continue;
        if (!lost_edges(check, &exam->variants[c][check->worst], exam->rubric))
            return NAMED_SHOWN;
        looks = NAMED_NO_EDGES;
    }
    return looks;
}

// Of all checks in question, or with `shown` of those that show anything.
static double distance(const LabResult *result, int m, Exam *exam, const bool failed[], bool shown,
                       double *to_reference) {
    double sum = 0;
    *to_reference = 0;
    for (int c = 0; c < result->check_count && sum < INFINITY; c++) {
        const CheckResult *check = &result->checks[c];
        if (!failed[c] || (shown && !shows_anything(check)))
            continue;
        const double own =
            check->yours[check->worst].rgba ? distance_in(check, m, c, exam, to_reference) : INFINITY;
        if (own < 0)
            return -1;
        sum += own;
    }
    return sum;
}

// Does a check pass that fails with the mistake?
static bool is_contradicted(const LabResult *result, int m, Exam *exam) {
    for (int c = 0; c < result->check_count; c++)
        if (result->checks[c].passed && !result->checks[c].otherwise &&
            exam_with_mistake(exam, m, c) != EXAM_PASSES)
            return true;
    return false;
}

static int nearest(const double distances[], int count, int but) {
    int best = -1;
    for (int m = 0; m < count; m++)
        if (m != but && distances[m] < (best < 0 ? INFINITY : distances[best]))
            best = m;
    return best;
}

static bool same_task(const Change *a, const Change *b) {
    return a->task && b->task && strcmp(a->task, b->task) == 0;
}

// The nearest, and of those that are at most `alike` farther away the next; more of them are only counted.
static void choose(Named *named, const double distances[], double alike, const Rubric *rubric) {
    const int count = rubric->mistake_count, first = nearest(distances, count, -1);
    const int second = first < 0 ? -1 : nearest(distances, count, first);
    int alikes = 0, tasks = 0;
    named->first = first;
    named->second = second >= 0 && distances[second] <= distances[first] + alike ? second : -1;
    for (int m = 0; m < count && first >= 0; m++)
        if (distances[m] < INFINITY && distances[m] <= distances[first] + alike) {
            alikes++;
            tasks += !same_task(&rubric->mistakes[m], &rubric->mistakes[first]);
        }
    named->many = alikes > 2 && tasks > 0;
}

bool catalogue_find(Named *named, const LabResult *result, Exam *exam, const bool failed[],
                    const ResetFound *found) {
    const Rubric *rubric = exam->rubric;
    double reference = 0, distances[EXAM_MAX_MISTAKES];
    *named = (Named){.first = -1, .second = -1, .looks = looks_of(result, exam, failed)};
    const bool shown = named->looks != NAMED_PLAIN;
    const bool placed = result->fault.count > 0 || (found && found->any);
    if (!shown && !placed)
        return true;
    INVARIANT(rubric->mistake_count <= EXAM_MAX_MISTAKES);
    for (int m = 0; m < rubric->mistake_count; m++) {
        const Change *mistake = &rubric->mistakes[m];
        distances[m] = INFINITY;
        if (!lies_in_fault(mistake, &result->fault, rubric) || !lies_in_found(mistake, found, exam))
            continue;
        const double own = distance(result, m, exam, failed, shown, &reference);
        if (own < 0)
            return false;
        if (own < INFINITY && (shown || own == 0) && !is_contradicted(result, m, exam))
            distances[m] = own;
    }
    choose(named, distances, ALIKE * reference, rubric);
    return true;
}
