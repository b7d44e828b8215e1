#include "exam/exam_facts.h"

#include <string.h>

enum { FIRST_RESET = EXAM_MAX_MISTAKES + EXAM_MAX_TASKS };

static json_t *pack_facts(const FrameFacts *facts) {
    return json_pack("[i, i, i]", facts->refused, facts->stage_width, facts->stage_height);
}

static void put_late_facts(json_t *list, const LatePicture *late, int i, const FrameFacts *usual) {
    if (memcmp(&late->facts, usual, sizeof *usual) == 0 || !late->known)
        return;
    json_array_append_new(list, json_integer(i));
    json_array_append_new(list, pack_facts(&late->facts));
}

json_t *exam_facts_pack(const Exam *exam, int c, int n) {
    const FrameFacts *usual = &exam->variants[c][n].facts;
    json_t *list = json_array();
    json_array_append_new(list, pack_facts(usual));
    for (int m = 0; m < exam->rubric->mistake_count; m++)
        put_late_facts(list, &exam->mistakes[m][c][n], m, usual);
    for (int t = 0; t < EXAM_MAX_TASKS; t++)
        put_late_facts(list, &exam->partials[t][c][n], EXAM_MAX_MISTAKES + t, usual);
    for (int p = 0; p < EXAM_MAX_PARTS; p++)
        put_late_facts(list, &exam->resets[p][c][n], FIRST_RESET + p, usual);
    return list;
}

static FrameFacts unpack_facts(json_t *list) {
    FrameFacts facts = {0};
    json_unpack(list, "[i, i, i]", &facts.refused, &facts.stage_width, &facts.stage_height);
    return facts;
}

void exam_facts_unpack(Exam *exam, int c, int n, json_t *list) {
    const FrameFacts usual = exam->variants[c][n].facts = unpack_facts(json_array_get(list, 0));
    for (int m = 0; m < EXAM_MAX_MISTAKES; m++)
        exam->mistakes[m][c][n].facts = usual;
    for (int t = 0; t < EXAM_MAX_TASKS; t++)
        exam->partials[t][c][n].facts = usual;
    for (int p = 0; p < EXAM_MAX_PARTS; p++)
        exam->resets[p][c][n].facts = usual;
    for (size_t i = 1; i + 1 < json_array_size(list); i += 2) {
        int late = (int)json_integer_value(json_array_get(list, i));
        const FrameFacts facts = unpack_facts(json_array_get(list, i + 1));
        if (late >= 0 && late < EXAM_MAX_MISTAKES)
            exam->mistakes[late][c][n].facts = facts;
        else if (late >= 0 && late < FIRST_RESET)
            exam->partials[late - EXAM_MAX_MISTAKES][c][n].facts = facts;
        else if (late >= 0 && late < FIRST_RESET + EXAM_MAX_PARTS)
            exam->resets[late - FIRST_RESET][c][n].facts = facts;
    }
}
