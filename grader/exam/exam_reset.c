// Draws our lab with a part as it was handed out, and with two of them, when first asked for; as JSON what
// hides what.
#include "exam/exam_reset.h"

#include "exam/handed_out.h"
#include "scene/check.h"
#include "score/score.h"

#include <stdlib.h>
#include <string.h>

// Of the pixels that a part changes: so many may differ by what else is another.
static const double HIDDEN = 0.05;

const Parts *exam_parts(Exam *exam) {
    char *texts[RUBRIC_MAX_FILES] = {0};
    bool ok = true;
    if (exam->parts)
        return exam->parts;
    for (int i = 0; ok && i < exam->rubric->file_count; i++)
        ok = (texts[i] = handed_out_text(exam->rubric, i)) != NULL;
    if (!ok) {
        for (int i = 0; i < RUBRIC_MAX_FILES; i++)
            free(texts[i]);
        return NULL;
    }
    exam->parts = calloc(1, sizeof *exam->parts);
    INVARIANT(exam->parts);
    parts_list(exam->parts, exam->rubric, texts);
    return exam->parts;
}

// The solution's part is mostly the one that was handed out: then the reference is the picture.
static bool is_solved_as_handed_out(const Parts *parts, int p) {
    for (int t = 0; t < parts->rubric->hint_count; t++)
        if (parts_have_task(parts, p, parts->rubric->hints[t].task))
            return false;
    return true;
}

const Image *exam_reset(Exam *exam, int p, int c, int n) {
    const Variant *variant = &exam->variants[c][n];
    LatePicture *late = &exam->resets[p][c][n];
    const Parts *parts = exam_parts(exam);
    if (!parts)
        return NULL;
    if (!late->known && is_solved_as_handed_out(parts, p))
        *late = (LatePicture){.known = true, .drawn = true, .facts = variant->facts};
    if (late->known)
        return exam_shown(late, variant);
    if (exam->painters)
        return exam_late(late, exam, variant, painters_reset(exam->painters, parts, p, -1));
    check_fail("a picture is missing in the recorded exam %llu of lab %s", (unsigned long long)exam->seed,
               exam->rubric->id);
    return NULL;
}

static ExamHidden draw_hidden(Exam *exam, int p, int q, int c) {
    static Reply reply;
    const Variant *variant = &exam->variants[c][0];
    const Image *with_p = exam_reset(exam, p, c, 0), *with_q = exam_reset(exam, q, c, 0);
    if (!with_p || !with_q)
        return EXAM_HIDDEN_UNKNOWN;
    const size_t shown = score_count(with_q, &variant->reference);
    if (shown == 0)
        return EXAM_HIDDEN;
    if (score_count(with_p, &variant->reference) == 0)
        return EXAM_SEEN;
    const Painter *painter =
        exam->painters ? painters_reset(exam->painters, exam->parts, p < q ? p : q, p < q ? q : p) : NULL;
    Image both = {0};
    ExamHidden hidden = EXAM_HIDDEN_UNKNOWN;
    if (painter && painters_draw(exam->painters, painter, &variant->request, &both, &reply))
        hidden = (double)score_count(with_p, &both) <= HIDDEN * (double)shown ? EXAM_HIDDEN : EXAM_SEEN;
    image_destroy(&both);
    return hidden;
}

ExamHidden exam_hidden(Exam *exam, int p, int q, int c) {
    INVARIANT(p >= 0 && p < EXAM_MAX_PARTS && q >= 0 && q < EXAM_MAX_PARTS);
    ExamHidden *hidden = &exam->hidden[p][q][c];
    if (*hidden == EXAM_HIDDEN_UNKNOWN)
        *hidden = draw_hidden(exam, p, q, c);
    return *hidden;
}

json_t *exam_hidden_pack(Exam *exam) {
    json_t *list = json_array();
    const Parts *parts = exam_parts(exam);
    for (int p = 0; parts && p < parts->count; p++) {
        json_t *row = json_array();
        for (int q = 0; q < parts->count; q++) {
            char text[RUBRIC_MAX_CHECKS + 1] = "";
            for (int c = 0; c < exam->rubric->check_count; c++)
                text[c] = "?.s"[p == q ? EXAM_HIDDEN : exam_hidden(exam, p, q, c)];
            json_array_append_new(row, json_string(text));
        }
        json_array_append_new(list, row);
    }
    check_clear(); // of parts that cannot stand alone
    return list;
}

bool exam_hidden_unpack(Exam *exam, json_t *list) {
    const Parts *parts = exam_parts(exam);
    for (int p = 0; parts && p < parts->count; p++)
        for (int q = 0; q < parts->count; q++) {
            const char *text = json_string_value(json_array_get(json_array_get(list, (size_t)p), (size_t)q));
            if (!text || strlen(text) != (size_t)exam->rubric->check_count)
                return false;
            for (int c = 0; text[c]; c++)
                exam->hidden[p][q][c] = text[c] == '.'   ? EXAM_HIDDEN
                                        : text[c] == 's' ? EXAM_SEEN
                                                         : EXAM_HIDDEN_UNKNOWN;
        }
    return parts != NULL;
}
