// Traces as the truth does, with fewer rays and other random numbers, and takes the time.
#include "study/rays.h"

#include "scene/check.h"
#include "truth/pixels.h"

#include <math.h>
#include <time.h>

enum { SEED = 0x5eed };

void rays_add_methods(MethodList *list) {
    for (int across = 1; across <= TRUTH_MAX_ACROSS; across *= 2) {
        int rays = across * across;
        Method *method = method_add(list, METHOD_RAYS, "ray tracing",
                                    rays == 1 ? "%d ray a pixel" : "%d rays a pixel", rays);
        method->rays = rays;
    }
}

// Of all threads of this process.
static double cpu_milliseconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static bool shoot(const Truth *truth, const TruthView *truth_view, TruthQuery query, int rays,
                  float *visibility) {
    TruthPicture picture = {0};
    query.samples = rays;
    query.seed ^= SEED;
    bool ok = truth_picture_create(&picture, truth_view->size.width, truth_view->size.height);
    if (ok)
        truth_look(truth, &picture);
    if (ok && rays == 1)
        ok = truth_trace(truth, &picture, &query, visibility);
    else if (ok)
        ok = pixels_trace(truth, &picture, &query, (int)lrint(sqrt(rays)), visibility);
    truth_picture_destroy(&picture);
    return ok;
}

bool rays_draw(const StudyView *view, const StudyScene *scene, int rays, float *visibility,
               MeasuredTime *time) {
    Truth truth;
    double start = cpu_milliseconds();
    if (!truth_create(&truth, &view->truth_view.truth.scene))
        return false;
    double built = cpu_milliseconds();
    bool ok = shoot(&truth, &view->truth_view, scene->query, rays, visibility);
    double end = cpu_milliseconds();
    truth_destroy(&truth);
    *time = (MeasuredTime){.prepare = built - start, .shade = end - built};
    return ok;
}
