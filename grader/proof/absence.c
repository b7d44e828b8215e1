#include "proof/absence.h"

#include "proof/scene_needs.h"
#include "scene/check.h"

#include <stdlib.h>
#include <string.h>

static bool draw(Painters *painters, Solved solved, Variant *variant, Image *image) {
    static Reply reply;
    const Painter *painter = painters_get(painters, solved, NULL);
    if (!painter || !painters_draw(painters, painter, &variant->request, image, &reply))
        return false;
    variant->facts = reply.facts;
    return true;
}

bool absence_draw_variant(Variant *variant, Painters *painters, const char *task) {
    return draw(painters, (Solved){SOLVED_NONE, NULL}, variant, &variant->skeleton) &&
           draw(painters, (Solved){SOLVED_ALL_BUT, task}, variant, &variant->without) &&
           draw(painters, (Solved){SOLVED_ALL, NULL}, variant, &variant->reference);
}

static bool take_away(Absence *absence, const Exam *whole, int c, int n) {
    Variant *variant = &absence->exam->variants[c][n];
    absence->lacks[c][n] = true;
    *variant = (Variant){.scene = whole->variants[c][n].scene, .request = whole->variants[c][n].request};
    scene_needs_take_away(&variant->request.scene, absence->thing);
    if (!absence_draw_variant(variant, absence->exam->painters, whole->rubric->checks[c].task))
        return false;
    absence->unfit = absence->unfit || !exam_acceptable(variant, 0);
    return true;
}

bool absence_create(Absence *absence, const Exam *whole, const char *scene, int thing) {
    bool ok = true;
    *absence = (Absence){.scene = scene, .thing = thing, .exam = calloc(1, sizeof *absence->exam)};
    INVARIANT(absence->exam);
    absence->exam->rubric = whole->rubric;
    absence->exam->painters = whole->painters;
    absence->exam->seed = whole->seed;
    memcpy(absence->exam->variants, whole->variants, sizeof whole->variants);
    for (int c = 0; c < whole->rubric->check_count; c++)
        for (int n = 0; ok && n < whole->rubric->checks[c].variants; n++)
            if (strcmp(whole->variants[c][n].scene, scene) == 0 &&
                scene_needs_has(&whole->variants[c][n].request.scene, thing))
                ok = take_away(absence, whole, c, n);
    return ok;
}

void absence_destroy(Absence *absence) {
    for (int c = 0; c < RUBRIC_MAX_CHECKS; c++)
        for (int n = 0; n < EXAM_MAX_VARIANTS; n++)
            if (absence->exam && !absence->lacks[c][n])
                absence->exam->variants[c][n] = (Variant){0}; // the whole exam's
    if (absence->exam)
        exam_destroy(absence->exam);
    free(absence->exam);
    *absence = (Absence){0};
}

bool absence_concerns(const Absence *absence, int c) {
    for (int n = 0; n < EXAM_MAX_VARIANTS; n++)
        if (absence->lacks[c][n])
            return true;
    return false;
}
