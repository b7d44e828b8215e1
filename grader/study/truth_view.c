#include "study/truth_view.h"

#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t pixels(const Ground *ground) {
    return (size_t)ground->size.width * (size_t)ground->size.height;
}

static bool allocate(Ground *ground) {
    size_t count = pixels(ground);
    ground->traced = calloc(count, sizeof *ground->traced);
    ground->drawn = calloc(count, sizeof *ground->drawn);
    ground->facing = calloc(count, sizeof *ground->facing);
    ground->visibility = calloc(count, sizeof *ground->visibility);
    ground->distance = calloc(count, sizeof *ground->distance);
    return (ground->traced && ground->drawn && ground->facing && ground->visibility && ground->distance) ||
           check_fail("out of memory for a truth of %d x %d pixels", ground->size.width, ground->size.height);
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

Request ground_request(const Ground *ground, const Setting *setting) {
    return setting_request(setting, &ground->truth.scene, ground->size);
}

static bool draw_primitives(Ground *ground, Artist *artist) {
    static Reply reply;
    Image image = {0};
    const Setting setting = {.view = VIEW_PRIMITIVES};
    const Request request = ground_request(ground, &setting);
    bool ok = artist_draw(artist, &request, &image, &reply);
    for (size_t i = 0; ok && i < pixels(ground); i++)
        ground->drawn[i] = metrics_decode_primitive(image.rgba + 4 * i);
    image_destroy(&image);
    return ok;
}

// By which light a pixel must be faced to count.
static float facing(const Ground *ground, const TruthQuery *query, const TruthHit *hit) {
    if (query->kind == TRUTH_OCCLUSION)
        return hit->object == TRUTH_NONE ? -1 : 1;
    return truth_facing(&ground->truth.scene, hit, query->kind == TRUTH_LIGHTS ? TRUTH_NONE : query->light);
}

bool ground_create(Ground *ground, const Scene *scene, MetricsSize size, const TruthQuery *query,
                   Artist *artist) {
    *ground = (Ground){.size = size};
    if (!allocate(ground) || !truth_create(&ground->truth, scene) ||
        !truth_picture_create(&ground->picture, size.width, size.height))
        return false;
    truth_look(&ground->truth, &ground->picture);
    for (size_t i = 0; i < pixels(ground); i++) {
        const TruthHit *hit = &ground->picture.hits[i];
        ground->traced[i] = metrics_primitive(hit->object, hit->triangle);
        ground->facing[i] = facing(ground, query, hit);
    }
    return draw_primitives(ground, artist) &&
           truth_trace(&ground->truth, &ground->picture, query, ground->visibility) &&
           metrics_boundary(size, ground->traced, ground->visibility, ground->distance);
}

void ground_destroy(Ground *ground) {
    truth_picture_destroy(&ground->picture);
    truth_destroy(&ground->truth);
    free(ground->traced);
    free(ground->drawn);
    free(ground->facing);
    free(ground->visibility);
    free(ground->distance);
    *ground = (Ground){0};
}

void setting_knob(Setting *setting, const char *name, float value) {
    INVARIANT(setting->knob_count < LAB_MAX_KNOBS);
    KnobSetting *knob = &setting->knobs[setting->knob_count++];
    INVARIANT(snprintf(knob->name, sizeof knob->name, "%s", name) < (int)sizeof knob->name);
    knob->value = value;
}

static bool draw(const Ground *ground, Artist *artist, const Request *request, Measured *measured) {
    static Reply reply;
    Image image = {0};
    bool ok = artist_draw(artist, request, &image, &reply);
    for (size_t i = 0; ok && i < pixels(ground); i++)
        measured->visibility[i] = image.rgba[4 * i + 3] ? (float)image.rgba[4 * i] / 255 : NAN;
    image_destroy(&image);
    memcpy(measured->milliseconds, reply.milliseconds, sizeof measured->milliseconds);
    return ok;
}

static void compare(const Ground *ground, const Setting *setting, Measured *measured) {
    const MetricsPixels given = {ground->drawn, ground->traced, ground->facing, measured->visibility};
    metrics_mask(ground->size, &given, measured->mask);
    for (size_t i = 0; setting->object != TRUTH_NONE && i < pixels(ground); i++)
        measured->mask[i] = measured->mask[i] && ground->picture.hits[i].object == setting->object;
    float edge = setting->edge_width > 0 ? setting->edge_width : METRICS_LEAST_EDGE;
    measured->metrics = metrics_compare(ground->size, measured->mask, measured->visibility,
                                        ground->visibility, ground->distance, edge);
}

bool ground_measure(const Ground *ground, Artist *artist, const Setting *setting, bool fresh,
                    Measured *measured) {
    Request request = ground_request(ground, setting);
    request.fresh = fresh;
    *measured = (Measured){.visibility = calloc(pixels(ground), sizeof *measured->visibility),
                           .mask = calloc(pixels(ground), 1)};
    if (!measured->visibility || !measured->mask)
        return check_fail("out of memory for a frame");
    if (!draw(ground, artist, &request, measured))
        return false;
    compare(ground, setting, measured);
    return true;
}

void measured_destroy(Measured *measured) {
    free(measured->visibility);
    free(measured->mask);
    *measured = (Measured){0};
}
