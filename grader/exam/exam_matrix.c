#include "exam/exam_matrix.h"

#include "scene/check.h"
#include "score/score.h"

static bool fails(const Image *picture, const Variant *variant) {
    return score_frame(picture, &variant->reference, &variant->without, &variant->skeleton).share <
           SCORE_PASSED;
}

static ExamEntry draw_entry(Exam *exam, int t, int c) {
    static Reply reply;
    const Solved solved = {SOLVED_ALL_BUT, exam->rubric->hints[t].task};
    const Painter *painter = exam->painters ? painters_get(exam->painters, solved, NULL) : NULL;
    Image picture = {0};
    ExamEntry entry = painter ? EXAM_PASSES : EXAM_UNKNOWN;
    for (int n = 0; entry == EXAM_PASSES && n < exam->rubric->checks[c].variants; n++) {
        const Variant *variant = &exam->variants[c][n];
        if (!painters_draw(exam->painters, painter, &variant->request, &picture, &reply))
            entry = EXAM_UNKNOWN;
        else if (fails(&picture, variant))
            entry = EXAM_FAILS;
    }
    image_destroy(&picture);
    return entry;
}

ExamEntry exam_without_task(Exam *exam, int t, int c) {
    INVARIANT(t >= 0 && t < EXAM_MAX_TASKS);
    ExamEntry *entry = &exam->without_task[t][c];
    if (*entry == EXAM_UNKNOWN)
        *entry = draw_entry(exam, t, c);
    return *entry;
}

ExamEntry exam_with_mistake(Exam *exam, int m, int c) {
    for (int n = 0; n < exam->rubric->checks[c].variants; n++) {
        const Image *picture = exam_mistake(exam, m, c, n);
        if (!picture)
            return EXAM_UNKNOWN;
        if (fails(picture, &exam->variants[c][n]))
            return EXAM_FAILS;
    }
    return EXAM_PASSES;
}
