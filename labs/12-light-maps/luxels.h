// What a luxel sees of the lamp, by rays. And the names of knobs and programs.
#pragma once

#include "atlas.h"
#include "lab.h"
#include "ray.h"
#include "samples.h"

enum { KNOB_DENSITY, KNOB_PADDING, KNOB_SHADOWS, KNOB_RAYS, KNOB_MAP_SIZE, KNOB_MEMORY, KNOB_PATTERN };
enum { SHADOWS_NONE, SHADOWS_BY_RAYS, SHADOWS_BY_MAP };
enum { PROGRAM_DEPTH, PROGRAM_BAKE, PROGRAM_DILATE, PROGRAM_PICTURE };

#define FAR_AWAY 1000.0f // world units: no scene is as large

// Balls move; planes and boxes stand still.
static bool moves(const Object *object) {
    return object->shape == SHAPE_SPHERE;
}

// The scene with only those objects that move, or with only those that stand still.
static Scene part_of_scene(const Scene *scene, bool moving) {
    Scene part = *scene;
    part.object_count = 0;
    for (int i = 0; i < scene->object_count; i++) {
        // TODO(12.8): leave out what does not belong to this part. Until then both parts hold everything.
        UNUSED(moving, moves);
        part.objects[part.object_count++] = scene->objects[i];
    }
    return part;
}

// Given: a place on the lamp, from two numbers in [0, 1) x [0, 1); the lamp's position if it has no size.
static vec3s place_on_lamp(const Light *light, vec2s pair) {
    vec3s right, up, place = light->position;
    light_axes(light, &right, &up);
    place = glms_vec3_add(place, glms_vec3_scale(right, (2 * pair.x - 1) * light->extent));
    return glms_vec3_add(place, glms_vec3_scale(up, (2 * pair.y - 1) * light->extent));
}

// The share of the lamp that is seen from a place on a chart, by so many rays. `still` holds what may be in
// the way; the luxel's number is the seed of its rays.
static float seen_share(const Scene *still, const Chart *chart, vec3s place, int luxel, int rays) {
    const Light *light = &still->lights[0];
    vec3s origin = glms_vec3_add(place, glms_vec3_scale(chart->normal, RAY_OFFSET));
    int seen = rays;
    // TODO(12.6): cast a ray from `origin` to `rays` places on the lamp, and count those that hit nothing.
    // The i-th place is place_on_lamp of sample_pair(luxel, i, rays). Nothing beyond the lamp is in the way.
    // A LIGHT_DIRECTIONAL shines from its position to its target, everywhere, from FAR_AWAY. Until then all
    // rays count as seen. Look up: ray_hits in common/scene/ray.h, sample_pair in common/scene/samples.h.
    UNUSED(light, origin, luxel, place_on_lamp);
    return (float)seen / (float)rays;
}

// Given: the same for all luxels of all charts.
static void look_from_luxels(const Frame *frame, const Scene *still, Atlas *atlas) {
    int rays = still->lights[0].extent > 0 ? (int)frame->knobs[KNOB_RAYS] : 1;
    for (int c = 0; c < atlas->chart_count; c++) {
        const Chart *chart = &atlas->charts[c];
        for (int i = 0; i < chart->width * chart->height; i++) {
            int x = i % chart->width, y = i / chart->width;
            int luxel = (chart->bottom + y) * atlas->width + chart->left + x;
            vec3s place = atlas_position(chart, ((float)x + 0.5f) / (float)chart->width,
                                         ((float)y + 0.5f) / (float)chart->height);
            atlas->texels[luxel] = seen_share(still, chart, place, luxel, rays);
        }
    }
}
