// Draws the variants of one check after the other without the object, and each known mistake in them, until a
// verdict changes.
#include "proof/scene_power.h"

#include "proof/absence.h"
#include "proof/scene_needs.h"
#include "scene/check.h"
#include "score/score.h"

#include <stdio.h>
#include <string.h>

// A check's variants without the object; those of other scenes stay empty.
typedef struct Lacking {
    Variant variants[EXAM_MAX_VARIANTS];
    bool is_one[EXAM_MAX_VARIANTS];
} Lacking;

bool scene_power_has(const Exam *exam, const char *scene, int thing) {
    for (int c = 0; c < exam->rubric->check_count; c++)
        for (int n = 0; n < exam->rubric->checks[c].variants; n++)
            if (strcmp(exam->variants[c][n].scene, scene) == 0 &&
                scene_needs_has(&exam->variants[c][n].request.scene, thing))
                return true;
    return false;
}

static bool draw(Painters *painters, const Change *mistake, const Request *request, Image *image) {
    static Reply reply;
    const Painter *painter = painters_get(painters, (Solved){SOLVED_ALL, NULL}, mistake);
    return painter && painters_draw(painters, painter, request, image, &reply);
}

// True when the scene had one of them. The last goes first: those behind it move up.
static bool take_away(Scene *scene, PowerThings things) {
    bool had = false;
    for (int thing = ECONOMY_THINGS - 1; thing >= 0; thing--)
        if (things >> thing & 1 && scene_needs_has(scene, thing)) {
            scene_needs_take_away(scene, thing);
            had = true;
        }
    return had;
}

// `why` is told when one of them would be refused.
static bool draw_lacking(Lacking *lacking, const Exam *exam, int c, const char *scene, PowerThings things,
                         char why[POWER_TEXT]) {
    const Check *check = &exam->rubric->checks[c];
    bool ok = true;
    for (int n = 0; ok && !why[0] && n < check->variants; n++) {
        const Variant *whole = &exam->variants[c][n];
        lacking->variants[n] = (Variant){.scene = whole->scene, .request = whole->request};
        lacking->is_one[n] =
            strcmp(whole->scene, scene) == 0 && take_away(&lacking->variants[n].request.scene, things);
        if (!lacking->is_one[n])
            continue;
        ok = absence_draw_variant(&lacking->variants[n], exam->painters, check->task);
        if (ok && !exam_acceptable(&lacking->variants[n], 0))
            snprintf(why, POWER_TEXT, "check \"%s\" would not be asked", check->name);
    }
    return ok;
}

static double share_in(const Variant *variant, const Image *picture) {
    return score_frame(picture, &variant->reference, &variant->without, &variant->skeleton).share;
}

// Adds what the mistake has of the points of a variant, with the object and without it.
static bool add_shares(double sums[2], Exam *exam, const Lacking *lacking, int c, int n, int m) {
    const Variant *variant = &lacking->variants[n];
    const Image *whole = exam_mistake(exam, m, c, n);
    Image image = {0};
    bool ok = whole && draw(exam->painters, &exam->rubric->mistakes[m], &variant->request, &image);
    sums[0] += ok ? share_in(&exam->variants[c][n], whole) : 0;
    sums[1] += ok ? share_in(variant, &image) : 0;
    image_destroy(&image);
    return ok;
}

static bool try_mistakes(const Lacking *lacking, Exam *exam, int c, char why[POWER_TEXT]) {
    const Check *check = &exam->rubric->checks[c];
    bool ok = true;
    for (int m = 0; ok && !why[0] && m < exam->rubric->mistake_count; m++) {
        double sums[2] = {0};
        int count = 0;
        for (int n = 0; ok && n < check->variants; n++)
            if (lacking->is_one[n]) {
                ok = add_shares(sums, exam, lacking, c, n, m);
                count++;
            }
        const bool passes = sums[0] >= SCORE_PASSED * count, would = sums[1] >= SCORE_PASSED * count;
        if (ok && passes != would)
            snprintf(why, POWER_TEXT, "check \"%s\" would %s \"%s\"", check->name, would ? "pass" : "fail",
                     exam->rubric->mistakes[m].name);
    }
    return ok;
}

static void destroy(Lacking *lacking) {
    for (int n = 0; n < EXAM_MAX_VARIANTS; n++) {
        image_destroy(&lacking->variants[n].reference);
        image_destroy(&lacking->variants[n].without);
        image_destroy(&lacking->variants[n].skeleton);
    }
}

bool scene_power_find(Exam *exam, const char *scene, PowerThings things, char why[POWER_TEXT]) {
    static Lacking lacking;
    bool ok = true;
    INVARIANT(exam->painters);
    why[0] = '\0';
    for (int c = 0; ok && !why[0] && c < exam->rubric->check_count; c++) {
        if (!rubric_uses_scene(&exam->rubric->checks[c], scene))
            continue;
        lacking = (Lacking){0};
        ok = draw_lacking(&lacking, exam, c, scene, things, why) &&
             (why[0] || try_mistakes(&lacking, exam, c, why));
        destroy(&lacking);
    }
    return ok;
}
