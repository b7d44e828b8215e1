// The way of one lab: take the files, compile, draw each check's variants, score them, diagnose, and give
// warnings and the ratio of times.
#include "grade/grade_lab.h"

#include "grade/address.h"
#include "grade/control.h"
#include "grade/hidden.h"
#include "grade/later_frame.h"
#include "scene/check.h"
#include "base/statistics.h"
#include "diagnose/diagnose.h"
#include "diagnose/evidence.h"
#include "grade/remarks.h"
#include "grade/score_check.h"
#include "grade/take_submission.h"
#include "grade/lab_verdict.h"
#include "score/score.h"

#include <stdio.h>
#include <string.h>

typedef struct Ratios {
    double values[RUBRIC_MAX_CHECKS];
    int count;
} Ratios;

// Draws one frame of the student's.
static DrawResult draw_one(LabResult *result, WorkerClient *student, const Variant *variant,
                           CheckResult *check, int n, Reply *reply, Remarks *remarks) {
    Image *yours = &check->yours[n];
    DrawResult drawn = worker_client_draw(student, &variant->request, yours, reply);
    check->facts[n] = reply->facts;
    if (drawn == DRAW_OK) {
        remarks_take(remarks, reply->remarks);
        if (reply->message[0])
            grade_warn(result, reply->message);
        if (score_not_finite(yours))
            grade_warn(result, score_not_finite(yours));
        return DRAW_OK;
    }
    image_destroy(yours);
    grade_fail(result, drawn == DRAW_TIMEOUT ? LAB_TIMEOUT : LAB_ERROR, reply->message);
    return drawn;
}

// A check in which the worker was lost has no pictures to judge: how it was lost is its cause.
static void lose_check(CheckResult *check, DrawResult drawn, const char *how) {
    for (int n = 0; n < EXAM_MAX_VARIANTS; n++)
        image_destroy(&check->yours[n]);
    result_clean(check->mistake, sizeof check->mistake, how);
    snprintf(check->kind, sizeof check->kind, "%s",
             drawn == DRAW_TIMEOUT ? "it ran out of its time" : "it crashed or ended by itself");
    check->has_cause = true;
}

// Draws the frames of check c. False when no more will come: the time is over, or the worker was lost too
// often.
static bool draw_check(LabResult *result, WorkerClient *student, const Exam *exam, int c, float *milliseconds,
                       Remarks *remarks) {
    static Reply reply;
    CheckResult *check = &result->checks[c];
    DrawResult drawn = DRAW_OK;
    int order[EXAM_MAX_VARIANTS];
    exam_order(exam, c, order);
    for (int i = 0; (drawn == DRAW_OK || drawn == DRAW_FAILED) && i < check->check->variants; i++) {
        const int n = order[i];
        drawn = draw_one(result, student, &exam->variants[c][n], check, n, &reply, remarks);
        if (drawn == DRAW_OK)
            *milliseconds = exam_milliseconds(&reply);
    }
    if (drawn == DRAW_OK || drawn == DRAW_FAILED)
        return true;
    if (drawn == DRAW_FAULT)
        return false;
    lose_check(check, drawn, reply.message);
    if (!student->muted)
        grade_quote(result, student->process.text);
    return worker_client_restart(student);
}

// The first frame of a check pays for what the driver compiles late: the last one is compared.
static float solution_milliseconds(const Exam *exam, int c) {
    int order[EXAM_MAX_VARIANTS];
    exam_order(exam, c, order);
    return exam->variants[c][order[exam->rubric->checks[c].variants - 1]].milliseconds;
}

static void add_ratio(Ratios *ratios, float milliseconds, const Exam *exam, int c) {
    float ours = milliseconds > 0 ? solution_milliseconds(exam, c) : 0;
    if (ours > 0)
        ratios->values[ratios->count++] = milliseconds / ours;
}

// An optional check of a task that is as it was handed out.
static bool is_left(const CheckResult *check, const Variant *variants) {
    return check->check->optional && !check->begun && result_touch(check, variants) != TOUCH_CHANGED;
}

// Every check but those that are left, and the pass mark of what was touched. Predictions count points only:
// who predicted wrong may have done the lab, and who predicted right has not done it yet.
static bool passes(const LabResult *result, const Exam *exam) {
    double score = 0, most = rubric_check_points(exam->rubric);
    for (int c = 0; c < result->check_count; c++) {
        const CheckResult *check = &result->checks[c];
        const bool left = is_left(check, exam->variants[c]);
        if (!check->passed && !left)
            return false;
        score += result_points(check);
        most -= left ? check->check->points : 0;
    }
    return score >= exam->rubric->pass_mark / 100 * most;
}

void grade_pictures(LabResult *result, Exam *exam) {
    if (!result_was_drawn(result))
        predictions_put_off(&result->predictions);
    result->score = predictions_points(&result->predictions);
    for (int c = 0; c < result->check_count; c++) {
        score_check(&result->checks[c], exam, c);
        result->score += result_points(&result->checks[c]);
    }
    if (!result->message[0])
        result->status = passes(result, exam) ? LAB_PASSED : LAB_FAILED;
}

bool grade_check(LabResult *result, Exam *exam, WorkerClient *student, int c) {
    float milliseconds;
    Remarks remarks = {0};
    draw_check(result, student, exam, c, &milliseconds, &remarks);
    score_check(&result->checks[c], exam, c);
    return result->checks[c].passed;
}

void grade_frames(LabResult *result, Exam *exam, WorkerClient *student, bool timed) {
    Ratios ratios = {0};
    Remarks remarks = {0};
    char text[sizeof remarks.lines];
    bool alive = true;
    student->restarts = 0;
    for (int c = 0; c < result->check_count; c++) {
        float milliseconds = 0;
        alive = alive && draw_check(result, student, exam, c, &milliseconds, &remarks);
        if (timed)
            add_ratio(&ratios, milliseconds, exam, c);
    }
    result->speed_ratio = ratios.count > 0 ? statistics_median(ratios.values, (size_t)ratios.count) : 0;
    grade_pictures(result, exam);
    remarks_write(&remarks, text, sizeof text);
    if (result->status == LAB_PASSED && exam->rubric->remarks && text[0])
        grade_warn(result, text);
}

// Not a point, as from a driver that draws nothing there: then ours must come out of the same jail.
static bool is_to_blame(const LabResult *result, LabExam *examiner, Exam *exam, const WorkerClient *student) {
    return result->score > predictions_points(&result->predictions) || !exam->painters ||
           control_draws(examiner, exam, student);
}

// The driver's words name the shader's file and line: nothing is left to be found.
static bool is_uncompiled(const LabResult *result) {
    return result->score <= predictions_points(&result->predictions) &&
           strstr(result->message, " does not compile:\n");
}

static bool examine(LabResult *result, LabExam *examiner, WorkerClient *student,
                    const GradeOptions *options) {
    if (!student->started)
        worker_client_start(student);
    Exam *exam = lab_exam_exam(examiner, options);
    if (!exam)
        return false;
    worker_client_begin(student);
    grade_frames(result, exam, student, exam->painters && !options->untimed);
    if (student->fault)
        return check_fail("%s", check_message()[0] ? check_message() : result->message);
    if (!is_to_blame(result, examiner, exam, student))
        return false;
    if (!student->muted) {
        grade_quote(result, student->process.text);
        address_explain(result, student, exam->rubric);
    } else if (!hidden_rehearse(result, student, exam->rubric)) {
        return false;
    }
    if (is_uncompiled(result))
        return true;
    if (options->early && !result_done(result))
        options->early(result, options->early_context);
    if (!diagnose(result, exam, student, options->no_swap ? FAULT_BY_RESET : FAULT_BY_SWAP) ||
        (options->evidence && !evidence_attach(result, exam, options->hidden)))
        return false;
    const char *remark = result->status == LAB_PASSED ? later_frame_remark(exam, student) : NULL;
    if (remark)
        grade_warn(result, remark);
    check_clear();
    return true;
}

bool grade_lab(LabResult *result, LabExam *examiner, const char *submission, const GradeOptions *options) {
    static WorkerClient student;
    student = (WorkerClient){.trust = TRUST_NOBODY,
                             .jail = options->jail,
                             .context = options->context,
                             .quick_shaders = true,
                             .muted = options->hidden,
                             .seconds = options->seconds,
                             .patience = options->patience};
    grade_begin(result, &examiner->rubric);
    if (!files_make_temporary(student.folder))
        return false;
    if (!options->jail) // it reads nothing yet; what is lent to a jail's user must be there before
        worker_client_start(&student);
    bool ok = predictions_take(&result->predictions, &examiner->rubric, submission) &&
              take_submission(result, &student, &examiner->rubric, submission);
    if (result->message[0])
        predictions_put_off(&result->predictions);
    if (ok && !result->message[0])
        ok = examine(result, examiner, &student, options);
    worker_client_stop(&student);
    files_remove(student.folder);
    return ok;
}
