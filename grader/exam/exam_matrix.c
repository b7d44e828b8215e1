#include "exam/exam_matrix.h"

#include "exam/frame_score.h"
#include "scene/check.h"

#include <string.h>

static bool fails(const Image *picture, const FrameFacts *facts, const Variant *variant) {
    return frame_score(picture, facts, variant, &variant->reference).share < SCORE_PASSED;
}

static ExamEntry draw_entry(Exam *exam, int t, int c) {
    static Reply reply;
    const Solved solved = {SOLVED_ALL_BUT, exam->rubric->hints[t].task};
    const Painter *painter = exam->painters ? painters_get(exam->painters, solved, NULL) : NULL;
    // Of a check about this very task no variant was taken in which it would pass.
    if (painter && rubric_task_index(exam->rubric, exam->rubric->checks[c].task) == t)
        return EXAM_FAILS;
    Image picture = {0};
    ExamEntry entry = painter ? EXAM_PASSES : EXAM_UNKNOWN;
    for (int n = 0; entry == EXAM_PASSES && n < exam->rubric->checks[c].variants; n++) {
        const Variant *variant = &exam->variants[c][n];
        if (!painters_draw(exam->painters, painter, &variant->request, &picture, &reply))
            entry = EXAM_UNKNOWN;
        else if (fails(&picture, &reply.facts, variant))
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
        if (fails(picture, &exam->mistakes[m][c][n].facts, &exam->variants[c][n]))
            return EXAM_FAILS;
    }
    return EXAM_PASSES;
}

json_t *exam_matrix_pack(Exam *exam) {
    json_t *list = json_array();
    for (int t = 0; t < exam->rubric->hint_count; t++) {
        char row[RUBRIC_MAX_CHECKS + 1] = "";
        for (int c = 0; c < exam->rubric->check_count; c++)
            row[c] = "?.F"[exam_without_task(exam, t, c)];
        json_array_append_new(list, json_string(row));
    }
    return list;
}

bool exam_matrix_unpack(Exam *exam, json_t *list) {
    for (int t = 0; t < exam->rubric->hint_count; t++) {
        const char *row = json_string_value(json_array_get(list, (size_t)t));
        if (!row || strlen(row) != (size_t)exam->rubric->check_count)
            return false;
        for (int c = 0; row[c]; c++)
            exam->without_task[t][c] = row[c] == 'F'   ? EXAM_FAILS
                                       : row[c] == '.' ? EXAM_PASSES
                                                       : EXAM_UNKNOWN;
    }
    return true;
}
