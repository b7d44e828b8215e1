// Draws variants until enough are worth asking, and later pictures (mistakes, partly solved labs) when they
// are first asked for.
#include "exam/exam.h"

#include "scene/check.h"
#include "exam/exam_draw.h"
#include "score/score.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_TRIES = 300 }; // a rounding that goes wrong (lab 07) shows in a third of them
static const double MIN_MASK = 0.01;

float exam_milliseconds(const Reply *reply) {
    float sum = 0;
    for (int i = 0; i < LAB_MAX_PASSES; i++)
        sum += reply->milliseconds[i];
    return sum;
}

static bool scores(const Image *picture, const Variant *variant) {
    return score_is_any(picture, &variant->reference, &variant->without, &variant->skeleton);
}

static bool trivial_scores(const Variant *variant) {
    Image plain = {0};
    uint8_t mean[3];
    score_mean_color(&variant->reference, mean);
    if (!image_copy(&plain, &variant->reference))
        return true;
    score_fill(&plain, (const uint8_t[3]){0, 0, 0});
    bool found = scores(&plain, variant);
    score_fill(&plain, mean);
    found = found || scores(&plain, variant);
    image_destroy(&plain);
    return found;
}

// Does what is missing in the other picture show?
static bool shows(const Variant *variant, const Image *other) {
    return score_mask(&variant->reference, other) >= MIN_MASK;
}

bool exam_acceptable(const Variant *variants, int n) {
    const Variant *variant = &variants[n];
    if (!shows(variant, &variant->skeleton) || !shows(variant, &variant->without) || trivial_scores(variant))
        return false;
    for (int i = 0; i < n; i++)
        if (scores(&variants[i].reference, variant) || scores(&variant->reference, &variants[i]))
            return false;
    return true;
}

typedef struct Trio {
    Painters *painters;
    const Painter *solution, *skeleton, *without;
} Trio;

static bool draw_reference(Variant *variant, const Trio *trio, char renderer[128]) {
    static Reply reply;
    if (!painters_draw(trio->painters, trio->solution, &variant->request, &variant->reference, &reply))
        return false;
    memcpy(renderer, reply.renderer, sizeof reply.renderer);
    variant->facts = reply.facts;
    variant->milliseconds = exam_milliseconds(&reply);
    return reply.drawn ||
           check_fail("our own solution in %s draws nothing: %s", trio->solution->folder, reply.message);
}

// A variant in which the whole lab does not show is not acceptable, and its third picture is not drawn.
static bool draw_variant(Variant *variant, const Trio *trio, char renderer[128]) {
    static Reply reply;
    return draw_reference(variant, trio, renderer) &&
           painters_draw(trio->painters, trio->skeleton, &variant->request, &variant->skeleton, &reply) &&
           (!shows(variant, &variant->skeleton) ||
            painters_draw(trio->painters, trio->without, &variant->request, &variant->without, &reply));
}

static bool create_check(Exam *exam, int c, const Trio *trio) {
    const Check *check = &exam->rubric->checks[c];
    Draw draw = draw_begin_check(exam->rubric, exam->seed, c);
    bool ok = true;
    int n = 0;
    for (int try = 0; ok && n < check->variants && try < MAX_TRIES; try++) {
        Variant *variant = &exam->variants[c][n];
        exam->tries[c][n] = try;
        variant->scene = draw_scene_name(&draw, check, n);
        ok = draw_request(&draw, &variant->request, check, n) && draw_variant(variant, trio, exam->renderer);
        n += ok && exam_acceptable(exam->variants[c], n);
    }
    exam->scarce = ok && n < check->variants;
    if (exam->scarce)
        return check_fail(
            "lab %s, check \"%s\": seed %llu gives only %d of %d variants in which the task shows; "
            "try another seed or fix the rubric",
            exam->rubric->id, check->name, (unsigned long long)exam->seed, n, check->variants);
    return ok;
}

// They grow, and no variant comes after the last that exam_create draws.
static bool are_tries(const int *tries, int count) {
    for (int n = 0; n < count; n++)
        if (tries[n] < 0 || tries[n] >= MAX_TRIES || (n > 0 && tries[n] <= tries[n - 1]))
            return false;
    return true;
}

bool exam_restore(Exam *exam, const Rubric *rubric, uint64_t seed,
                  int tries[RUBRIC_MAX_CHECKS][EXAM_MAX_VARIANTS]) {
    memset(exam, 0, sizeof *exam);
    exam->rubric = rubric;
    exam->seed = seed;
    for (int c = 0; c < rubric->check_count; c++) {
        if (!are_tries(tries[c], rubric->checks[c].variants))
            return false;
        Draw draw = draw_begin_check(rubric, seed, c);
        int drawn = 0;
        for (int n = 0; n < rubric->checks[c].variants; n++) {
            exam->tries[c][n] = tries[c][n];
            exam->variants[c][n].scene = draw_scene_name(&draw, &rubric->checks[c], n);
            for (; drawn <= tries[c][n]; drawn++)
                if (!draw_request(&draw, &exam->variants[c][n].request, &rubric->checks[c], n))
                    return false;
        }
    }
    return true;
}

bool exam_create(Exam *exam, const Rubric *rubric, Painters *painters, uint64_t seed) {
    memset(exam, 0, sizeof *exam);
    exam->rubric = rubric;
    exam->painters = painters;
    exam->seed = seed;
    if (!painters_fit(painters))
        return false;
    for (int c = 0; c < rubric->check_count; c++) {
        Trio trio = {painters, painters_get(painters, (Solved){SOLVED_ALL, NULL}, NULL),
                     painters_get(painters, (Solved){SOLVED_NONE, NULL}, NULL),
                     painters_get(painters, (Solved){SOLVED_ALL_BUT, rubric->checks[c].task}, NULL)};
        if (!trio.solution || !trio.skeleton || !trio.without || !create_check(exam, c, &trio)) {
            exam_destroy(exam);
            return false;
        }
    }
    return true;
}

void exam_order(const Exam *exam, int c, int order[EXAM_MAX_VARIANTS]) {
    Random random = {~exam->seed ^ (uint64_t)c << 32};
    for (int n = 0; n < EXAM_MAX_VARIANTS; n++)
        order[n] = n;
    for (int n = exam->rubric->checks[c].variants - 1; n > 0; n--) {
        const int other = random_int(&random, 0, n), last = order[n];
        order[n] = order[other];
        order[other] = last;
    }
}

const Image *exam_shown(const LatePicture *late, const Variant *variant) {
    return late->image.rgba ? &late->image : &variant->reference;
}

// Most mistakes do not show in most checks: of those that draw the reference, nothing is kept.
const Image *exam_late(LatePicture *late, const Exam *exam, const Variant *variant, const Painter *painter) {
    static Reply reply;
    if (!painter || !painters_draw(exam->painters, painter, &variant->request, &late->image, &reply))
        return NULL;
    late->known = true;
    late->drawn = reply.drawn;
    late->facts = reply.facts;
    if (memcmp(late->image.rgba, variant->reference.rgba, image_bytes(&late->image)) == 0)
        image_destroy(&late->image);
    return exam_shown(late, variant);
}

static const Image *draw_late(LatePicture *late, const Exam *exam, const Variant *variant, Solved solved,
                              const Change *change) {
    if (late->known)
        return exam_shown(late, variant);
    if (exam->painters)
        return exam_late(late, exam, variant, painters_get(exam->painters, solved, change));
    check_fail("a picture is missing in the recorded exam %llu of lab %s", (unsigned long long)exam->seed,
               exam->rubric->id);
    return NULL;
}

const Image *exam_mistake(Exam *exam, int m, int c, int n) {
    return draw_late(&exam->mistakes[m][c][n], exam, &exam->variants[c][n], (Solved){SOLVED_ALL, NULL},
                     &exam->rubric->mistakes[m]);
}

const Image *exam_also(Exam *exam, int a, int c, int n) {
    return draw_late(&exam->also[a][c][n], exam, &exam->variants[c][n], (Solved){SOLVED_ALL, NULL},
                     exam->rubric->also[a]);
}

const Image *exam_partial(Exam *exam, int t, int c, int n) {
    const char *task = t < EXAM_MAX_TASKS ? rubric_task(exam->rubric, t) : NULL;
    return task ? draw_late(&exam->partials[t][c][n], exam, &exam->variants[c][n],
                            (Solved){SOLVED_UP_TO, task}, NULL)
                : NULL;
}

typedef void VisitLate(LatePicture *late, size_t *bytes);

static void visit_late(Exam *exam, int c, int n, VisitLate *visit, size_t *bytes) {
    for (int m = 0; m < EXAM_MAX_MISTAKES; m++)
        visit(&exam->mistakes[m][c][n], bytes);
    for (int t = 0; t < EXAM_MAX_TASKS; t++)
        visit(&exam->partials[t][c][n], bytes);
    for (int a = 0; a < RUBRIC_MAX_ALSO; a++)
        visit(&exam->also[a][c][n], bytes);
    for (int p = 0; p < EXAM_MAX_PARTS; p++)
        visit(&exam->resets[p][c][n], bytes);
}

static void visit_all_late(Exam *exam, int checks, VisitLate *visit, size_t *bytes) {
    for (int c = 0; c < checks; c++)
        for (int n = 0; n < EXAM_MAX_VARIANTS; n++)
            visit_late(exam, c, n, visit, bytes);
}

static void weigh_late(LatePicture *late, size_t *bytes) {
    *bytes += late->image.rgba ? image_bytes(&late->image) : 0;
}

static void forget_late(LatePicture *late, size_t *bytes) {
    (void)bytes;
    image_destroy(&late->image);
    *late = (LatePicture){0};
}

void exam_forget_late(Exam *exam, size_t most) {
    const int checks = exam->rubric->check_count;
    size_t bytes = 0;
    if (!exam->painters)
        return;
    visit_all_late(exam, checks, weigh_late, &bytes);
    if (bytes > most)
        visit_all_late(exam, checks, forget_late, &bytes);
}

void exam_destroy(Exam *exam) {
    visit_all_late(exam, RUBRIC_MAX_CHECKS, forget_late, NULL);
    for (int c = 0; c < RUBRIC_MAX_CHECKS; c++)
        for (int n = 0; n < EXAM_MAX_VARIANTS; n++) {
            image_destroy(&exam->variants[c][n].reference);
            image_destroy(&exam->variants[c][n].without);
            image_destroy(&exam->variants[c][n].skeleton);
        }
    if (exam->parts)
        parts_destroy(exam->parts);
    free(exam->parts);
    exam->parts = NULL;
}
