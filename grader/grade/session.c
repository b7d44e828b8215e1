// Grades lab after lab of a submission with one set of options, and keeps each lab's exam for the next
// submission where asked to.
#include "grade/session.h"

#include "scene/check.h"
#include "base/places.h"
#include "exam/nursery_client.h"
#include "grade/attempt.h"
#include "grade/found_lab.h"
#include "intake/submission.h"
#include "grade/lab_verdict.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Adding {
    Session *session;
    bool ok;
} Adding;

static void add_lab(const char *id, void *context) {
    Adding *adding = context;
    Session *session = adding->session;
    if (!adding->ok)
        return;
    if (session->lab_count == COURSE_MAX_LABS) {
        adding->ok = check_fail("more than %d labs at once", COURSE_MAX_LABS);
        return;
    }
    adding->ok = lab_exam_open(&session->examiners[session->lab_count], id);
    session->lab_count += adding->ok;
}

bool session_add(Session *session, const char *id) {
    Adding adding = {session, true};
    if (id)
        add_lab(id, &adding);
    else if (!places_list_labs(add_lab, &adding))
        return false;
    return adding.ok;
}

void session_begin(Session *session) {
    if (session->lab_count == 1 && !session->attempts)
        lab_exam_begin(&session->examiners[0], &session->options);
}

static bool begin_report(Session *session, Report *report) {
    const Jail *jail = session->options.jail;
    *report = (Report){.seed = session->options.seed,
                       .hidden = session->options.hidden,
                       .jail = jail_route_name(jail ? jail->route : JAIL_NONE),
                       .context = context_name(session->options.context),
                       .labs = calloc(COURSE_MAX_LABS, sizeof *report->labs)};
    return report->labs || check_fail("out of memory");
}

// Somebody who hands in one lab, and is not asked for all, is not told of the others.
static bool is_left_out(const Session *session, const Submission *submission) {
    return !session->complete && submission->single;
}

static bool grade_one(Session *session, const Submission *submission, int i, Report *report) {
    LabExam *examiner = &session->examiners[i];
    char note[RESULT_TEXT], text[800];
    const char *theirs =
        submission_find_of(submission, examiner->rubric.id, session->lab_count, note, sizeof note);
    bool ok = true;
    check_clear();
    if (!theirs && is_left_out(session, submission))
        return true;
    LabResult *result = &report->labs[report->lab_count++];
    if (theirs) {
        if (!session->keep)
            lab_exam_begin(examiner, &session->options);
        ok = grade_lab(result, examiner, theirs, &session->options);
        grade_warn(result, note);
    } else {
        found_lab_missing(text, sizeof text, submission, &examiner->rubric);
        grade_begin(result, &examiner->rubric);
        grade_refuse(result, text);
        result->missing = !submission_nameless(submission) && !submission->why[0];
    }
    grade_warn(result, submission->note);
    if (ok && result_was_drawn(result)) // whatever the exam was drawn for before
        memcpy(report->renderer, examiner->exam->renderer, sizeof report->renderer);
    lab_exam_trim(examiner);
    if (!session->keep)
        lab_exam_forget(examiner);
    else if (session->lab_count > 1)
        lab_exam_rest(examiner);
    return ok;
}

static bool refuse_all(Session *session, const char *reason, Report *report) {
    for (int i = 0; i < session->lab_count; i++) {
        LabResult *result = &report->labs[report->lab_count++];
        grade_begin(result, &session->examiners[i].rubric);
        grade_refuse(result, reason);
    }
    return true;
}

bool session_grade(Session *session, const char *path, Report *report) {
    static Submission submission;
    double start = process_now();
    if (!begin_report(session, report))
        return false;
    const Extracted opened = submission_open(&submission, session->options.jail, path);
    if (session->attempts)
        report->seed = session->options.seed =
            session->meets
                ? *session->meets
                : attempt_seed(session->secret, &submission, session->examiners, session->lab_count);
    bool ok = opened == EXTRACT_OK ||
              (opened == EXTRACT_BAD_ARCHIVE && refuse_all(session, check_message(), report));
    for (int i = 0; opened == EXTRACT_OK && ok && i < session->lab_count; i++)
        ok = grade_one(session, &submission, i, report);
    report->seconds = process_now() - start;
    submission_close(&submission);
    if (!ok)
        session_free(report);
    return ok;
}

void session_free(Report *report) {
    for (int i = 0; i < report->lab_count; i++)
        result_destroy_lab(&report->labs[i]);
    free(report->labs);
    *report = (Report){0};
}

void session_close(Session *session) {
    for (int i = 0; i < session->lab_count; i++)
        lab_exam_close(&session->examiners[i]);
    session->lab_count = 0;
    nursery_stop();
}
