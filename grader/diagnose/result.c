#include "diagnose/result.h"

#include "scene/check.h"
#include "score/score.h"

#include <math.h>

const char *result_status_name(LabStatus status) {
    static const char *const names[] = {"passed", "failed", "error", "timeout"};
    return names[status];
}

double result_points(const CheckResult *check) {
    return round(check->share * check->check->points * 100) / 100;
}

Touch result_touch(const CheckResult *check, const Variant *variants) {
    double to_without = 0, to_skeleton = 0;
    for (int n = 0; n < check->check->variants; n++) {
        to_without += score_rmse(&check->yours[n], &variants[n].without);
        to_skeleton += score_rmse(&check->yours[n], &variants[n].skeleton);
    }
    return to_without == 0 ? TOUCH_TASK_MISSING : to_skeleton == 0 ? TOUCH_AS_SKELETON : TOUCH_CHANGED;
}

bool result_done(const LabResult *lab) {
    for (int c = 0; c < lab->check_count; c++)
        if (!lab->checks[c].passed && !lab->checks[c].check->optional)
            return false;
    return !lab->message[0];
}

bool result_task_passed(const LabResult *lab, const Rubric *rubric, int task) {
    int own = 0, passed = 0;
    for (int c = 0; c < lab->check_count; c++)
        if (rubric_task_index(rubric, lab->checks[c].check->task) == task) {
            own++;
            passed += lab->checks[c].passed;
        }
    return own > 0 && passed == own;
}

bool result_was_drawn(const LabResult *lab) {
    for (int c = 0; c < lab->check_count; c++)
        if (lab->checks[c].yours[0].rgba)
            return true;
    return false;
}

double result_score(const Report *report) {
    double score = 0;
    for (int i = 0; i < report->lab_count; i++)
        score += report->labs[i].score;
    return score;
}

double result_max_score(const Report *report) {
    double score = 0;
    for (int i = 0; i < report->lab_count; i++)
        score += report->labs[i].max_score;
    return score;
}

void result_destroy_lab(LabResult *lab) {
    for (int c = 0; c < lab->check_count; c++) {
        for (int n = 0; n < EXAM_MAX_VARIANTS; n++)
            image_destroy(&lab->checks[c].yours[n]);
        for (int n = 0; n < EVIDENCE_PARTS; n++)
            image_destroy(&lab->checks[c].evidence[n]);
    }
}

void result_clean(char *clean, size_t size, const char *text) {
    clean[0] = '\0';
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        check_append(clean, size, (c >= ' ' && c < 0x7f) || c == '\n' || c == '\t' ? "%c" : "\\x%02x", c);
    }
}
