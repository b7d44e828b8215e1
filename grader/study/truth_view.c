// Asks the worker for the triangles of a view, traces the truth, draws a method, and compares on the pixels
// where both meet the same triangle.
#include "study/truth_view.h"

#include "scene/check.h"
#include "truth/pixels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t pixels(const TruthView *truth_view) {
    return (size_t)truth_view->size.width * (size_t)truth_view->size.height;
}

static bool allocate(TruthView *truth_view) {
    size_t count = pixels(truth_view);
    truth_view->traced = calloc(count, sizeof *truth_view->traced);
    truth_view->drawn = calloc(count, sizeof *truth_view->drawn);
    truth_view->facing = calloc(count, sizeof *truth_view->facing);
    truth_view->visibility = calloc(count, sizeof *truth_view->visibility);
    truth_view->distance = calloc(count, sizeof *truth_view->distance);
    return (truth_view->traced && truth_view->drawn && truth_view->facing && truth_view->visibility &&
            truth_view->distance) ||
           check_fail("out of memory for a truth of %d x %d pixels", truth_view->size.width,
                      truth_view->size.height);
}

Request setting_request(const Setting *setting, const Scene *scene, MetricsSize size) {
    Request request = {.magic = PROTOCOL_MAGIC,
                       .width = size.width,
                       .height = size.height,
                       .knob_count = setting->knob_count,
                       .scene = *scene};
    snprintf(request.view, sizeof request.view, "%s", setting->view);
    memcpy(request.knobs, setting->knobs, sizeof request.knobs);
    return request;
}

Request truth_view_request(const TruthView *truth_view, const Setting *setting) {
    return setting_request(setting, &truth_view->truth.scene, truth_view->size);
}

static bool draw_primitives(TruthView *truth_view, LabArtist *artist) {
    static Reply reply;
    Image image = {0};
    const Setting setting = {.view = VIEW_PRIMITIVES};
    const Request request = truth_view_request(truth_view, &setting);
    bool ok = lab_artist_draw(artist, &request, &image, &reply);
    for (size_t i = 0; ok && i < pixels(truth_view); i++)
        truth_view->drawn[i] = metrics_decode_primitive(image.rgba + 4 * i);
    image_destroy(&image);
    return ok;
}

bool truth_view_create(TruthView *truth_view, const Scene *scene, MetricsSize size, const TruthQuery *query,
                       LabArtist *artist) {
    Scene *seen = malloc(sizeof *seen);
    INVARIANT(seen);
    *truth_view = (TruthView){.size = size};
    *seen = *scene;
    lab_artist_leave_out(artist, seen);
    bool ok = allocate(truth_view) && truth_create(&truth_view->truth, seen);
    free(seen);
    if (!ok || !truth_picture_create(&truth_view->picture, size.width, size.height))
        return false;
    truth_look(&truth_view->truth, &truth_view->picture);
    for (size_t i = 0; i < pixels(truth_view); i++) {
        const TruthHit *hit = &truth_view->picture.hits[i];
        truth_view->traced[i] = metrics_primitive(hit->object, hit->triangle);
        truth_view->facing[i] = pixels_facing(scene, query, hit);
    }
    return draw_primitives(truth_view, artist) &&
           truth_trace(&truth_view->truth, &truth_view->picture, query, truth_view->visibility) &&
           metrics_boundary(size, truth_view->traced, truth_view->visibility, truth_view->distance);
}

bool truth_view_take(TruthView *truth_view, float *visibility, float *noise) {
    INVARIANT(!truth_view->center);
    truth_view->center = truth_view->visibility;
    truth_view->visibility = visibility;
    truth_view->noise = noise;
    return metrics_boundary(truth_view->size, truth_view->traced, visibility, truth_view->distance);
}

bool truth_view_refine(TruthView *truth_view, const TruthQuery *query, int across) {
    float *visibility = malloc(pixels(truth_view) * sizeof *visibility);
    float *noise = malloc(pixels(truth_view) * sizeof *noise);
    bool ok = (visibility && noise) || check_fail("out of memory for the truth of whole pixels");
    if (ok && pixels_trace_twice(&truth_view->truth, &truth_view->picture, query, across, visibility, noise))
        return truth_view_take(truth_view, visibility, noise);
    free(visibility);
    free(noise);
    return false;
}

void truth_view_destroy(TruthView *truth_view) {
    truth_picture_destroy(&truth_view->picture);
    truth_destroy(&truth_view->truth);
    free(truth_view->traced);
    free(truth_view->drawn);
    free(truth_view->facing);
    free(truth_view->visibility);
    free(truth_view->distance);
    free(truth_view->center);
    free(truth_view->noise);
    *truth_view = (TruthView){0};
}

void setting_knob(Setting *setting, const char *name, float value) {
    INVARIANT(setting->knob_count < LAB_MAX_KNOBS);
    KnobSetting *knob = &setting->knobs[setting->knob_count++];
    int length = snprintf(knob->name, sizeof knob->name, "%s", name);
    INVARIANT(length < (int)sizeof knob->name);
    knob->value = value;
}

bool truth_view_draw(LabArtist *artist, const Request *request, float *visibility, float *milliseconds) {
    static Reply reply;
    Image image = {0};
    bool ok = lab_artist_draw(artist, request, &image, &reply);
    for (size_t i = 0; ok && i < image_bytes(&image) / 4; i++)
        visibility[i] = image.rgba[4 * i + 3] ? (float)image.rgba[4 * i] / 255 : NAN;
    image_destroy(&image);
    if (milliseconds)
        memcpy(milliseconds, reply.milliseconds, sizeof reply.milliseconds);
    return ok;
}

void truth_view_compare(const TruthView *truth_view, const Setting *setting, Measured *measured) {
    const MetricsPixels given = {truth_view->drawn, truth_view->traced, truth_view->facing,
                                 measured->visibility};
    metrics_mask(truth_view->size, &given, measured->mask);
    for (size_t i = 0; setting->object != TRUTH_NONE && i < pixels(truth_view); i++)
        measured->mask[i] = measured->mask[i] && truth_view->picture.hits[i].object == setting->object;
    float edge = setting->edge_width > 0 ? setting->edge_width : METRICS_LEAST_EDGE;
    measured->metrics = metrics_compare(truth_view->size, measured->mask, measured->visibility,
                                        truth_view->visibility, truth_view->distance, edge);
}

bool truth_view_measure(const TruthView *truth_view, LabArtist *artist, const Setting *setting, bool fresh,
                        Measured *measured) {
    Request request = truth_view_request(truth_view, setting);
    request.fresh = fresh;
    if (!measured_create(measured, truth_view->size))
        return false;
    if (!truth_view_draw(artist, &request, measured->visibility, measured->milliseconds))
        return false;
    truth_view_compare(truth_view, setting, measured);
    return true;
}

bool measured_create(Measured *measured, MetricsSize size) {
    size_t count = (size_t)size.width * (size_t)size.height;
    *measured =
        (Measured){.visibility = calloc(count, sizeof *measured->visibility), .mask = calloc(count, 1)};
    return (measured->visibility && measured->mask) || check_fail("out of memory for a frame");
}

void measured_destroy(Measured *measured) {
    free(measured->visibility);
    free(measured->mask);
    *measured = (Measured){0};
}
