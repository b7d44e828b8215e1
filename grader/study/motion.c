// Moves the light or the camera step by step, traces what is true, and sums up what a method changes besides.
#include "study/motion.h"

#include "scene/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// How far frame i is turned, degrees.
static float turn_of(int i) {
    float turn = 0;
    for (int step = 1; step <= i; step++)
        turn += 0.3f * (1 + fmodf(0.618034f * (float)step, 1));
    return turn;
}

static void turn(vec3s *place, vec3s target, float degrees) {
    vec3s offset = glms_vec3_sub(*place, target);
    *place = glms_vec3_add(target, glms_vec3_rotate(offset, glm_rad(degrees), vec3_make(0, 1, 0)));
}

static void move(Scene *scene, MotionKind kind, int i) {
    if (kind == MOTION_CAMERA)
        turn(&scene->camera.eye, scene->camera.target, turn_of(i));
    for (int l = 0; kind == MOTION_LIGHT && l < scene->light_count; l++)
        turn(&scene->lights[l].position, scene->lights[l].target, turn_of(i));
}

static bool trace(MotionFrame *frame, const StudyScene *scene, MetricsSize size, LabArtist *artist) {
    TruthView truth_view = {0};
    const size_t pixels = (size_t)size.width * (size_t)size.height;
    frame->counts = calloc(pixels, 1);
    bool ok = (frame->counts || check_fail("out of memory for a frame that moves")) &&
              truth_view_create(&truth_view, &frame->scene, size, &scene->query, artist);
    const MetricsPixels given = {truth_view.drawn, truth_view.traced, truth_view.facing,
                                 truth_view.visibility};
    if (ok) {
        metrics_mask(size, &given, frame->counts);
        frame->truth = truth_view.visibility;
        truth_view.visibility = NULL;
    }
    truth_view_destroy(&truth_view);
    return ok;
}

bool motion_create(Motion *motion, const StudyScene *scene, const Scene *from, MetricsSize size,
                   LabArtist *artist) {
    bool ok = true;
    *motion = (Motion){.size = size};
    for (MotionKind kind = 0; kind < MOTION_KINDS; kind++)
        for (int i = 0; ok && i < MOTION_FRAMES; i++) {
            MotionFrame *frame = &motion->frames[kind][i];
            frame->scene = *from;
            move(&frame->scene, kind, i);
            study_settle(&frame->scene, scene);
            ok = trace(frame, scene, size, artist);
        }
    return ok;
}

void motion_destroy(Motion *motion) {
    for (MotionKind kind = 0; kind < MOTION_KINDS; kind++)
        for (int i = 0; i < MOTION_FRAMES; i++) {
            free(motion->frames[kind][i].truth);
            free(motion->frames[kind][i].counts);
        }
    *motion = (Motion){0};
}

double motion_changes(MetricsSize size, const float *const shown[2], const MotionFrame frames[2],
                      double *count) {
    double sum = 0;
    INVARIANT(frames[0].counts && frames[1].counts && shown[0] && shown[1]);
    for (size_t i = 0; i < (size_t)size.width * (size_t)size.height; i++) {
        if (!frames[0].counts[i] || !frames[1].counts[i] || !isfinite(shown[0][i]) || !isfinite(shown[1][i]))
            continue;
        sum += fabs((double)(shown[1][i] - shown[0][i])) -
               fabs((double)(frames[1].truth[i] - frames[0].truth[i]));
        (*count)++;
    }
    return sum;
}

static bool measure_kind(const Motion *motion, MotionKind kind, LabArtist *artist, const Setting *setting,
                         float *const shown[2], double *beyond) {
    double sum = 0, count = 0;
    bool ok = true;
    for (int i = 0; ok && i < MOTION_FRAMES; i++) {
        const MotionFrame *frame = &motion->frames[kind][i];
        Request request = setting_request(setting, &frame->scene, motion->size);
        request.fresh = i == 0;
        ok = truth_view_draw(artist, &request, shown[i % 2], NULL);
        if (ok && i > 0)
            sum += motion_changes(motion->size, (const float *const[2]){shown[(i - 1) % 2], shown[i % 2]},
                                  frame - 1, &count);
    }
    *beyond = count > 0 ? sum / count : 0;
    return ok;
}

bool motion_measure(const Motion *motion, LabArtist *artist, const Setting *setting,
                    double beyond[MOTION_KINDS]) {
    const size_t pixels = (size_t)motion->size.width * (size_t)motion->size.height;
    float *memory = calloc(2 * pixels, sizeof *memory);
    bool ok = memory || check_fail("out of memory for two frames that move");
    for (MotionKind kind = 0; ok && kind < MOTION_KINDS; kind++)
        ok = measure_kind(motion, kind, artist, setting, (float *const[2]){memory, memory + pixels},
                          &beyond[kind]);
    free(memory);
    return ok;
}
