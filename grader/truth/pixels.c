// One picture after the other, each through other places in the pixels, and their mean.
#include "truth/pixels.h"

#include "scene/check.h"
#include "truth/metrics.h"

#include <math.h>
#include <stdlib.h>

float pixels_facing(const Scene *scene, const TruthQuery *query, const TruthHit *hit) {
    if (query->kind == TRUTH_OCCLUSION || query->kind == TRUTH_DUST)
        return hit->object == TRUTH_NONE ? -1 : 1;
    return truth_facing(scene, hit, query->kind == TRUTH_LIGHTS ? TRUTH_NONE : query->light);
}

// Of one picture after the other; per pixel.
typedef struct Sums {
    TruthPicture picture;
    float *visibility, *counted;
} Sums;

static void add_picture(const Truth *truth, const TruthPicture *centers, const TruthQuery *query,
                        const Sums *sums, const float *traced, float *visibility) {
    size_t pixels = (size_t)centers->width * (size_t)centers->height;
    for (size_t i = 0; i < pixels; i++) {
        const TruthHit *hit = &sums->picture.hits[i];
        if (hit->object == TRUTH_NONE || hit->object != centers->hits[i].object ||
            pixels_facing(&truth->scene, query, hit) <= METRICS_LEAST_FACING)
            continue;
        visibility[i] += traced[i];
        sums->counted[i] += 1;
    }
}

static bool trace_all(const Truth *truth, const TruthPicture *centers, TruthQuery query, int across,
                      const Sums *sums, float *visibility) {
    query.parts = truth_is_soft(&truth->scene, &query) ? across * across : 0;
    TruthPicture picture = sums->picture;
    bool ok = true;
    for (int part = 0; ok && part < across * across; part++) {
        query.part = query.parts ? part : 0;
        truth_look_within(truth, &picture, &(TruthPlace){across, part, query.seed});
        ok = truth_trace(truth, &picture, &query, sums->visibility);
        if (ok)
            add_picture(truth, centers, &query, sums, sums->visibility, visibility);
    }
    return ok;
}

bool pixels_trace(const Truth *truth, const TruthPicture *centers, const TruthQuery *query, int across,
                  float *visibility) {
    size_t pixels = (size_t)centers->width * (size_t)centers->height;
    if (query->kind == TRUTH_DUST)
        return truth_trace(truth, centers, query, visibility);
    if (truth_is_soft(&truth->scene, query) && query->samples % (across * across) != 0)
        return check_fail("%d samples a pixel are no whole number in each of %d places of it", query->samples,
                          across * across);
    Sums sums = {.visibility = calloc(pixels, sizeof(float)), .counted = calloc(pixels, sizeof(float))};
    bool ok = sums.visibility && sums.counted;
    if (!ok)
        check_fail("out of memory for %zu pixels", pixels);
    ok = ok && truth_picture_create(&sums.picture, centers->width, centers->height);
    for (size_t i = 0; ok && i < pixels; i++)
        visibility[i] = 0;
    ok = ok && trace_all(truth, centers, *query, across, &sums, visibility);
    for (size_t i = 0; ok && i < pixels; i++)
        visibility[i] /= fmaxf(sums.counted[i], 1);
    truth_picture_destroy(&sums.picture);
    free(sums.visibility);
    free(sums.counted);
    return ok;
}

bool pixels_trace_twice(const Truth *truth, const TruthPicture *centers, const TruthQuery *query, int across,
                        float *visibility, float *noise) {
    size_t pixels = (size_t)centers->width * (size_t)centers->height;
    TruthQuery again = *query;
    again.seed = ~query->seed;
    if (!pixels_trace(truth, centers, query, across, visibility) ||
        !pixels_trace(truth, centers, &again, across, noise))
        return false;
    for (size_t i = 0; i < pixels; i++) {
        float a = visibility[i], b = noise[i];
        visibility[i] = (a + b) / 2;
        noise[i] = (a - b) / 2;
    }
    return true;
}
