// Draws a row and holds its score and its diagnosis against what is known of it: solution and alternatives
// get all points, the skeleton none, no task takes points away, a mistake fails and is named.
#include "proof/proof_row.h"

#include "diagnose/diagnose.h"
#include "grade/grade_lab.h"
#include "grade/remarks.h"
#include "grade/lab_verdict.h"

#include <stdio.h>
#include <string.h>

static void note(ProofRow *row, const char *text) {
    if (!row->other[0])
        snprintf(row->other, sizeof row->other, "%.120s", text);
}

// Is the mistake named in a failed check, first of what it may be, and nothing else in any?
static bool named_right(const LabResult *result, ProofRow *row) {
    bool named = false;
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        if (check->passed)
            continue;
        if (strncmp(check->mistake, row->change->name, strlen(row->change->name)) != 0) {
            note(row, check->has_cause ? check->mistake : result->message);
            return false;
        }
        named = true;
    }
    return named;
}

static bool all_zero(const LabResult *result, ProofRow *row) {
    for (int c = 0; c < result->check_count; c++)
        if (result->checks[c].share > 0) {
            note(row, result->checks[c].check->name);
            return false;
        }
    return true;
}

// A remark without points may hold for another right way, but our solution has none.
static bool has_notes(const LabResult *result, const ProofRow *row) {
    const char *text = result->warnings;
    while (row->kind == KIND_ALTERNATIVE && strncmp(text, REMARK, strlen(REMARK)) == 0) {
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    return text[0] != '\0';
}

static bool all_full(const LabResult *result, ProofRow *row) {
    for (int c = 0; c < result->check_count; c++)
        if (result->checks[c].share < 1) {
            note(row, result->checks[c].check->name);
            return false;
        }
    const bool notes = has_notes(result, row);
    if (result->message[0] || notes)
        note(row, result->message[0] ? result->message : result->warnings);
    return !result->message[0] && !notes;
}

static bool judge(const LabResult *result, ProofRow *row, const Rubric *rubric) {
    switch (row->kind) {
    case KIND_SKELETON:
        return all_zero(result, row);
    case KIND_PARTIAL:
        return row->earned >= row->before->earned - 1e-9;
    case KIND_MISTAKE:
        return named_right(result, row) && result->score < rubric->pass_mark / 100 * result->max_score &&
               result->status != LAB_PASSED;
    default:
        return all_full(result, row);
    }
}

static const Image *ours(const ProofRow *row, Exam *exam, int c, int n) {
    const Variant *variant = &exam->variants[c][n];
    if (row->kind == KIND_SKELETON)
        return &variant->skeleton;
    bool mistake = row->kind == KIND_MISTAKE;
    const Image *image =
        mistake ? exam_mistake(exam, row->number, c, n) : exam_partial(exam, row->number, c, n);
    const LatePicture *late =
        mistake ? &exam->mistakes[row->number][c][n] : &exam->partials[row->number][c][n];
    return image && late->drawn ? image : NULL;
}

static FrameFacts our_facts(const ProofRow *row, const Exam *exam, int c, int n) {
    return row->kind == KIND_SKELETON  ? (FrameFacts){0}
           : row->kind == KIND_MISTAKE ? exam->mistakes[row->number][c][n].facts
                                       : exam->partials[row->number][c][n].facts;
}

// Skeletons, partial solutions and mistakes are drawn for the diagnosis, too. Those frames are taken as the
// row's. False when one of them was not drawn: then the row's own worker has to say why.
static bool share_frames(LabResult *result, const ProofRow *row, Exam *exam) {
    if (row->kind != KIND_SKELETON && row->kind != KIND_PARTIAL && row->kind != KIND_MISTAKE)
        return false;
    for (int c = 0; c < result->check_count; c++)
        for (int n = 0; n < result->checks[c].check->variants; n++) {
            const Image *image = ours(row, exam, c, n);
            if (!image || !image_copy(&result->checks[c].yours[n], image))
                return false;
            result->checks[c].facts[n] = our_facts(row, exam, c, n);
        }
    return true;
}

// A worker that draws for one lab only and compiles its shaders well, and the one that draws for all of ours
// must show the same.
static bool draws_the_same(const LabResult *result, ProofRow *row, Exam *exam) {
    static LabResult shared;
    grade_begin(&shared, exam->rubric);
    bool same = true;
    if (share_frames(&shared, row, exam))
        for (int c = 0; same && c < shared.check_count; c++)
            for (int n = 0; same && n < shared.checks[c].check->variants; n++) {
                const Image *own = &result->checks[c].yours[n], *other = &shared.checks[c].yours[n];
                same = own->rgba && memcmp(own->rgba, other->rgba, image_bytes(own)) == 0;
            }
    result_destroy_lab(&shared);
    if (!same)
        note(row, "another picture in a worker of its own");
    return same;
}

static void draw_row(LabResult *result, ProofRow *row, const Painter *painter, Exam *exam) {
    row->contender.trust = TRUST_OURS;
    row->contender.context = exam->painters->context;
    memcpy(row->contender.folder, painter->folder, sizeof row->contender.folder);
    grade_begin(result, exam->rubric);
    grade_frames(result, exam, &row->contender, false);
}

// Most mistakes are named by their pictures alone, as in the student's kit. Where they draw nothing, only the
// part with the fault can tell.
static bool name_causes(LabResult *result, ProofRow *row, Exam *exam) {
    ProofRow unnamed = *row;
    return diagnose(result, exam, &row->contender, FAULT_BY_PICTURES) &&
           (row->kind != KIND_MISTAKE || named_right(result, &unnamed) ||
            diagnose(result, exam, &row->contender, FAULT_BY_SWAP));
}

// What the tasks up to the row's have earned, in percent: a check of a later task may be like ours by chance.
static double earned(const LabResult *result, int number) {
    double sum = 0;
    for (int c = 0; c < result->check_count; c++) {
        const char *dot = strchr(result->checks[c].check->task, '.');
        sum += dot && atoi(dot + 1) <= number ? result->checks[c].share * result->checks[c].check->points : 0;
    }
    return 100 * sum / result->max_score;
}

bool proof_row_run(ProofRow *row, Exam *exam, Painters *painters) {
    static LabResult result;
    const Painter *painter = painters_get(painters, row->solved, row->change);
    if (!painter)
        return false;
    bool first = row->seeds == 0, same = true;
    grade_begin(&result, exam->rubric);
    if (!first && share_frames(&result, row, exam)) {
        grade_pictures(&result, exam);
    } else {
        result_destroy_lab(&result);
        draw_row(&result, row, painter, exam);
        same = draws_the_same(&result, row, exam);
    }
    memcpy(row->contender.folder, painter->folder, sizeof row->contender.folder);
    bool ok = name_causes(&result, row, exam);
    if (row->kind != KIND_SKELETON) // as from somebody who predicted all numbers right
        result.score += predictions_max_points(&result.predictions);
    double percent = 100 * result.score / result.max_score;
    row->earned = earned(&result, row->number);
    if (first || percent < row->lowest)
        row->lowest = percent;
    if (first || percent > row->highest)
        row->highest = percent;
    row->seeds++;
    row->right += ok && same && judge(&result, row, exam->rubric);
    result_destroy_lab(&result);
    return ok;
}
