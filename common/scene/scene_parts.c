#include "scene/scene_parts.h"

#include "scene/check.h"
#include "scene/palette.h"

#include <string.h>

vec3s part_color(Random *random) {
    return vec3_make(random_range(random, PALETTE_DARKEST, 0.95f),
                     random_range(random, PALETTE_DARKEST, 0.95f),
                     random_range(random, PALETTE_DARKEST, 0.95f));
}

vec3s part_orbit(vec3s target, float azimuth, float elevation, float distance) {
    float a = glm_rad(azimuth), e = glm_rad(elevation);
    vec3s direction = vec3_make(cosf(e) * sinf(a), sinf(e), cosf(e) * cosf(a));
    return glms_vec3_add(target, glms_vec3_scale(direction, distance));
}

Object *part_object(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn, vec3s color) {
    INVARIANT(scene->object_count < SCENE_MAX_OBJECTS);
    mat4s placed = glms_rotate(glms_translate_make(center), glm_rad(turn), vec3_make(0, 1, 0));
    Object *object = &scene->objects[scene->object_count++];
    *object = (Object){.shape = shape,
                       .world_from_object = glms_scale(placed, half_size),
                       .color = color,
                       .specular = 0.3f,
                       .shininess = 32};
    return object;
}

Object *part_floor(Scene *scene, float half_size, Random *random) {
    Object *floor = part_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(half_size, 1, half_size), 0,
                                part_color(random));
    floor->specular = 0;
    return floor;
}

Light *part_light(Scene *scene, LightKind kind, vec3s position, vec3s target) {
    INVARIANT(scene->light_count < SCENE_MAX_LIGHTS);
    Light *light = &scene->lights[scene->light_count++];
    Random aside = {0};
    memcpy(&aside.state, &position, sizeof aside.state);
    *light = (Light){.kind = kind,
                     .position = position,
                     .target = target,
                     .color = vec3_make(0.8f, 0.8f, 0.75f),
                     .fov_y = glm_rad(50),
                     .half_size = 4.5f,
                     // Near and far close around the scene: more of the map's range is used.
                     .near_plane = random_range(&aside, 3.2f, 4),
                     .far_plane = random_range(&aside, 15.5f, 18)};
    return light;
}

void part_begin(Scene *scene, Random *random) {
    Random aside = {~random->state}; // takes nothing from what is drawn after it
    float azimuth = random_range(random, -35, 35), elevation = random_range(random, 28, 45);
    vec3s target = vec3_make(0, 0.4f, 0);
    float dim = random_range(random, 0.15f, 0.3f);
    *scene =
        (Scene){.camera = {.eye = part_orbit(target, azimuth, elevation, random_range(random, 8, 9.5f)),
                           .target = target,
                           .fov_y = glm_rad(40),
                           .near_plane = random_range(&aside, 0.25f, 0.8f),
                           .far_plane = random_range(&aside, 45, 80)},
                .ambient = vec3_make(dim, dim, dim * 1.1f),
                .background = vec3_make(random_range(random, 0.05f, 0.2f), random_range(random, 0.1f, 0.2f),
                                        random_range(random, 0.2f, 0.35f))};
    scene->second_camera = scene->camera;
}

void part_box(Scene *scene, float half_height, Random *random) {
    part_object(scene, SHAPE_BOX,
                vec3_make(random_range(random, -1.6f, -0.9f), half_height, random_range(random, -0.6f, 0.6f)),
                vec3_make(random_range(random, 0.4f, 0.6f), half_height, random_range(random, 0.4f, 0.6f)),
                random_range(random, 10, 80), part_color(random));
}

void part_casters(Scene *scene, Random *random) {
    float h = random_range(random, 0.5f, 0.8f), r = random_range(random, 0.45f, 0.65f);
    part_box(scene, h, random);
    part_object(scene, SHAPE_SPHERE,
                vec3_make(random_range(random, 0.7f, 1.4f), r + random_range(random, 0.2f, 0.6f),
                          random_range(random, -0.6f, 0.6f)),
                vec3_make(r, r, r), 0, part_color(random));
}

vec3s part_above(Random *random, float lowest, float highest, float distance) {
    float side = random_int(random, 0, 1) ? 1 : -1;
    float azimuth = side * random_range(random, 100, 160);
    return part_orbit(vec3_make(0, 0, 0), azimuth, random_range(random, lowest, highest), distance);
}
