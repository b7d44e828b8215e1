#include "grade/score_check.h"

#include "exam/frame_score.h"

static void take_worst(CheckResult *check, const FrameScore *score, int n, const Variant *variant) {
    double error = score->inside + score->outside;
    bool worse = score->share < check->share || (score->share == check->share && error > check->error);
    if (n > 0 && !worse)
        return;
    check->share = score->share;
    check->error = error;
    check->worst = n;
    check->wrong_size = frame_wrong_size(&check->facts[n], &variant->facts);
    check->refused = check->facts[n].refused;
}

static void score_solution(CheckResult *check, const Variant *variants) {
    for (int n = 0; n < check->check->variants; n++) {
        FrameScore score =
            frame_score(&check->yours[n], &check->facts[n], &variants[n], &variants[n].reference);
        take_worst(check, &score, n, &variants[n]);
    }
    check->passed = check->share >= SCORE_PASSED;
}

// Is the check passed when alternative a of "also right" is the reference?
static bool passes_also(const CheckResult *check, Exam *exam, int c, int a) {
    for (int n = 0; n < check->check->variants; n++) {
        const Image *ours = exam_also(exam, a, c, n);
        if (!ours ||
            frame_score(&check->yours[n], &check->facts[n], &exam->variants[c][n], ours).share < SCORE_PASSED)
            return false;
    }
    return true;
}

// Who draws as such an alternative does gets all points.
static void try_also(CheckResult *check, Exam *exam, int c) {
    for (int a = 0; check->share < 1 && check->yours[0].rgba && a < exam->rubric->also_count; a++)
        if (passes_also(check, exam, c, a)) {
            check->share = 1;
            check->error = 0;
            check->passed = check->otherwise = true;
        }
}

void score_check(CheckResult *check, Exam *exam, int c) {
    score_solution(check, exam->variants[c]);
    try_also(check, exam, c);
}
