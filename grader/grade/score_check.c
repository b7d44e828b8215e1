#include "grade/score_check.h"

#include "score/score.h"

static const double PASSED_SHARE = 0.95; // of a check's points

// What a frame in which GL refused a call gets of its points: it may be drawn otherwise by another driver.
static const double REFUSED_SHARE = 0.5;

// Without a frame the error is 1.
static FrameScore score_variant(const CheckResult *check, const Variant *variant, int n, const Image *ours) {
    const Image *yours = &check->yours[n];
    if (!yours->rgba || result_wrong_size(&check->facts[n], &variant->facts))
        return (FrameScore){.inside = 1};
    FrameScore score = score_frame(yours, ours, &variant->without, &variant->skeleton);
    if (check->facts[n].refused)
        score.share *= REFUSED_SHARE;
    return score;
}

static void take_worst(CheckResult *check, const FrameScore *score, int n, const Variant *variant) {
    double error = score->inside + score->outside;
    bool worse = score->share < check->share || (score->share == check->share && error > check->error);
    if (n > 0 && !worse)
        return;
    check->share = score->share;
    check->error = error;
    check->worst = n;
    check->wrong_size = result_wrong_size(&check->facts[n], &variant->facts);
    check->refused = check->facts[n].refused;
}

static void score_solution(CheckResult *check, const Variant *variants) {
    for (int n = 0; n < check->check->variants; n++) {
        FrameScore score = score_variant(check, &variants[n], n, &variants[n].reference);
        take_worst(check, &score, n, &variants[n]);
    }
    check->passed = check->share >= PASSED_SHARE;
}

// Is the check passed when alternative a of "also right" is the reference?
static bool passes_also(const CheckResult *check, Exam *exam, int c, int a) {
    for (int n = 0; n < check->check->variants; n++) {
        const Image *ours = exam_also(exam, a, c, n);
        if (!ours || score_variant(check, &exam->variants[c][n], n, ours).share < PASSED_SHARE)
            return false;
    }
    return true;
}

// Who draws as such an alternative does gets all points.
static void try_also(CheckResult *check, Exam *exam, int c) {
    for (int a = 0; !check->passed && check->yours[0].rgba && a < exam->rubric->also_count; a++)
        if (passes_also(check, exam, c, a)) {
            check->share = 1;
            check->error = 0;
            check->passed = true;
        }
}

void score_check(CheckResult *check, Exam *exam, int c) {
    score_solution(check, exam->variants[c]);
    try_also(check, exam, c);
}
