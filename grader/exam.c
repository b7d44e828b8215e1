#include "exam.h"

#include "check.h"
#include "score.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_TRIES = 60 };
static const double MIN_MASK = 0.01;

float exam_milliseconds(const Reply *reply) {
    float sum = 0;
    for (int i = 0; i < LAB_MAX_PASSES; i++)
        sum += reply->milliseconds[i];
    return sum;
}

static bool make_request(Request *request, const Check *check, Random *random) {
    *request = (Request){.magic = PROTOCOL_MAGIC, .fresh = 1, .knob_count = check->knob_count};
    snprintf(request->view, sizeof request->view, "%s", check->view);
    for (int i = 0; i < check->knob_count; i++) {
        snprintf(request->knobs[i].name, sizeof request->knobs[i].name, "%s", check->knobs[i].name);
        request->knobs[i].value = check->knobs[i].value;
    }
    return scene_make(&request->scene, check->scene, random);
}

static bool scores(const Image *picture, const Variant *variant) {
    return score_frame(picture, &variant->reference, &variant->without, &variant->skeleton).share > 0;
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

bool exam_acceptable(const Variant *variants, int n) {
    const Variant *variant = &variants[n];
    if (score_mask(&variant->reference, &variant->without) < MIN_MASK ||
        score_mask(&variant->reference, &variant->skeleton) < MIN_MASK || trivial_scores(variant))
        return false;
    for (int i = 0; i < n; i++)
        if (scores(&variants[i].reference, variant) || scores(&variant->reference, &variants[i]))
            return false;
    return true;
}

typedef struct Painters {
    Roster *roster;
    const Painter *solution, *skeleton, *without;
} Painters;

static bool draw_variant(Variant *variant, const Painters *painters, char renderer[128]) {
    static Reply reply;
    if (!roster_draw(painters->roster, painters->skeleton, &variant->request, &variant->skeleton, &reply) ||
        !roster_draw(painters->roster, painters->without, &variant->request, &variant->without, &reply) ||
        !roster_draw(painters->roster, painters->solution, &variant->request, &variant->reference, &reply))
        return false;
    memcpy(renderer, reply.renderer, sizeof reply.renderer);
    return reply.drawn ||
           check_fail("our own solution in %s draws nothing: %s", painters->solution->folder, reply.message);
}

static bool create_check(Exam *exam, int c, const Painters *painters) {
    const Check *check = &exam->rubric->checks[c];
    Random random = {exam->seed ^ (0x517cc1b727220a95u * (uint64_t)(c + 1))};
    random.state ^= (uint64_t)atoi(exam->rubric->id) << 32;
    const int width = 16 * random_int(&random, 9, 12), height = 16 * random_int(&random, 7, 9);
    bool ok = true;
    int n = 0;
    for (int try = 0; ok && n < check->variants && try < MAX_TRIES; try++) {
        Variant *variant = &exam->variants[c][n];
        ok = make_request(&variant->request, check, &random);
        variant->request.width = width;
        variant->request.height = height;
        ok = ok && draw_variant(variant, painters, exam->renderer);
        n += ok && exam_acceptable(exam->variants[c], n);
    }
    if (ok && n < check->variants)
        return check_fail(
            "lab %s, check \"%s\": seed %llu gives only %d of %d variants in which the task shows; "
            "try another seed or mend the rubric",
            exam->rubric->id, check->name, (unsigned long long)exam->seed, n, check->variants);
    return ok;
}

bool exam_create(Exam *exam, const Rubric *rubric, Roster *roster, uint64_t seed) {
    memset(exam, 0, sizeof *exam);
    exam->rubric = rubric;
    exam->seed = seed;
    for (int c = 0; c < rubric->check_count; c++) {
        Painters painters = {roster, roster_get(roster, (Solved){SOLVED_ALL, NULL}, NULL),
                             roster_get(roster, (Solved){SOLVED_NONE, NULL}, NULL),
                             roster_get(roster, (Solved){SOLVED_ALL_BUT, rubric->checks[c].task}, NULL)};
        if (!painters.solution || !painters.skeleton || !painters.without ||
            !create_check(exam, c, &painters)) {
            exam_destroy(exam);
            return false;
        }
    }
    return true;
}

const Image *exam_mistake(Exam *exam, Roster *roster, int m, int c, int n) {
    static Reply reply;
    Image *image = &exam->mistakes[m][c][n];
    if (image->rgba)
        return image;
    const Painter *mistaken = roster_get(roster, (Solved){SOLVED_ALL, NULL}, &exam->rubric->mistakes[m]);
    return mistaken && roster_draw(roster, mistaken, &exam->variants[c][n].request, image, &reply) ? image
                                                                                                   : NULL;
}

void exam_destroy(Exam *exam) {
    for (int c = 0; c < RUBRIC_MAX_CHECKS; c++)
        for (int n = 0; n < EXAM_MAX_VARIANTS; n++) {
            image_destroy(&exam->variants[c][n].reference);
            image_destroy(&exam->variants[c][n].without);
            image_destroy(&exam->variants[c][n].skeleton);
            for (int m = 0; m < EXAM_MAX_MISTAKES; m++)
                image_destroy(&exam->mistakes[m][c][n]);
        }
}
