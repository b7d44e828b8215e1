// Scenes with several lights, with a lamp in the middle, and with wide lights.
#include "scene/scene_parts.h"

enum { OVERHEAD_ONE_IN = 5 };

// Colours that differ, dim enough for the sum of `count` lights to stay below white. The first three of
// several have one channel each: no channel alone tells whether a light brings anything.
static vec3s light_color(Random *random, int i, int count) {
    float strength = 0.9f / (float)count;
    if (count > 2 && i < 3) {
        vec3s color = vec3_make(0, 0, 0);
        color.raw[i] = strength * random_range(random, 1.2f, 1.6f);
        return color;
    }
    vec3s color = vec3_make(strength, strength, strength);
    color.raw[i % 3] *= random_range(random, 0.1f, 0.4f);
    color.raw[(i + 1) % 3] *= random_range(random, 0.7f, 1);
    return color;
}

// Around the scene, at times straight above it.
static vec3s place_light(Random *random, float azimuth, float lowest, float highest, float distance) {
    vec3s place = part_orbit(vec3_make(0, 0, 0), azimuth, random_range(random, lowest, highest), distance);
    return random_int(random, 1, OVERHEAD_ONE_IN) == 1 ? vec3_make(0, distance, 0) : place;
}

// Spot lights and suns, mixed, that look to places beside the origin.
static void add_lights(Scene *scene, Random *random, int count) {
    float turn = random_range(random, 0, 360);
    for (int i = 0; i < count; i++) {
        float azimuth = turn + (360 * (float)i + random_range(random, -60, 60)) / (float)count;
        vec3s place = place_light(random, azimuth, 35, 65, random_range(random, 8.5f, 9.5f));
        vec3s aside = vec3_make(random_range(random, -0.4f, 0.4f), 0, random_range(random, -0.4f, 0.4f));
        LightKind kind = random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_DIRECTIONAL;
        part_light(scene, kind, glms_vec3_add(place, aside), aside)->color = light_color(random, i, count);
    }
}

static void make_one(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    add_lights(scene, random, 1);
}

static void make_several(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    add_lights(scene, random, random_int(random, 3, SCENE_MAX_LIGHTS));
}

// Boxes and balls all around a place, also above and below it.
static void add_around(Scene *scene, Random *random, vec3s middle) {
    static const float places[][3] = {{1, -0.1f, 0.2f},     {-1, 0.1f, -0.2f}, {0.2f, 1, -0.3f},
                                      {-0.1f, -1.1f, 0.2f}, {0.3f, 0, 1},      {-0.3f, -0.1f, -1.7f}};
    for (int i = 0; i < 6; i++) {
        vec3s aside = vec3_make(places[i][0], places[i][1], places[i][2]);
        float r = random_range(random, 0.15f, 0.3f), away = random_range(random, 0.8f, 1.1f);
        r *= i == 2 ? 2 : 1; // nothing else is above the lamp
        part_object(scene, random_int(random, 0, 1) ? SHAPE_BOX : SHAPE_SPHERE,
                    glms_vec3_add(middle, glms_vec3_scale(aside, away)), vec3_make(r, r, r),
                    random_range(random, 0, 90), part_color(random));
    }
}

// Low over the floor, nearer to their shadows than to the lamp: on both sides, and under it.
static void add_low(Scene *scene, Random *random, vec3s middle) {
    static const float azimuths[] = {90, 270, 40, -40};
    for (int i = 0; i < 4; i++) {
        float r = random_range(random, 0.15f, 0.25f),
              away = random_range(random, 0.8f, 1) * (i < 2 ? 2.3f : 0.8f);
        vec3s place = part_orbit(middle, azimuths[i] + random_range(random, -15, 15), 0, away);
        part_object(scene, random_int(random, 0, 1) ? SHAPE_BOX : SHAPE_SPHERE,
                    vec3_make(place.x, r + random_range(random, 0.05f, 0.15f), place.z), vec3_make(r, r, r),
                    random_range(random, 0, 90), part_color(random));
    }
}

// A wall that faces the middle from the distance `away`, after a turn about +y.
static void add_wall(Scene *scene, Random *random, float turn, float away) {
    Object *wall = part_object(scene, SHAPE_PLANE, part_orbit(vec3_make(0, 1.5f, 0), turn + 180, 0, away),
                               vec3_make(1, 1, 1), turn, part_color(random));
    mat4s standing = glms_rotate(wall->world_from_object, glm_rad(90), vec3_make(1, 0, 0));
    wall->world_from_object = glms_scale(standing, vec3_make(4, 1, 1.5f));
}

// A lamp between casters, over a floor and before a wall. It shines to all sides, whatever it looks at.
static Light *add_lamp(Scene *scene, Random *random) {
    vec3s middle = vec3_make(random_range(random, -0.5f, 0.5f), random_range(random, 1.3f, 1.6f),
                             random_range(random, -0.2f, 0.6f));
    add_around(scene, random, middle);
    add_low(scene, random, middle);
    vec3s aside = vec3_make(random_range(random, -1, 1), random_range(random, -1, 1), 1);
    Light *lamp = part_light(scene, LIGHT_POINT, middle, glms_vec3_add(middle, aside));
    lamp->near_plane = random_range(random, 0.1f, 0.4f);
    lamp->far_plane = random_range(random, 9, 16);
    return lamp;
}

static void make_room(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 4, random);
    add_wall(scene, random, random_range(random, -20, 20), 2.4f);
}

static void make_lamp(Scene *scene, Random *random) {
    make_room(scene, random);
    add_lamp(scene, random);
}

// The lamp is not the first light, nor the first that has a map.
static void make_lamp_later(Scene *scene, Random *random) {
    make_room(scene, random);
    add_lights(scene, random, random_int(random, 1, 2));
    add_lamp(scene, random);
}

// Casters that float, so that their soft shadows are seen.
static void add_floating(Scene *scene, Random *random) {
    for (int i = 0; i < 3; i++) {
        float r = random_range(random, 0.3f, 0.5f);
        part_object(scene, (i + random_int(random, 0, 1)) % 2 ? SHAPE_BOX : SHAPE_SPHERE,
                    vec3_make(0.95f * (float)i - 0.95f, random_range(random, 0.9f, 1.7f),
                              random_range(random, -0.7f, 0.7f)),
                    vec3_make(r, r * random_range(random, 0.5f, 1), r), random_range(random, 0, 90),
                    part_color(random));
    }
}

static void add_wide(Scene *scene, Random *random) {
    vec3s place = place_light(random, random_range(random, 0, 360), 50, 75, random_range(random, 6.5f, 8));
    vec3s aside = vec3_make(random_range(random, -0.5f, 0.5f), 0, random_range(random, -0.5f, 0.5f));
    Light *light = part_light(scene, LIGHT_SPOT, glms_vec3_add(place, aside), aside);
    light->extent = random_range(random, 0.5f, 0.9f);
    light->near_plane = 2;
}

static void make_wide(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    add_floating(scene, random);
    add_wide(scene, random);
}

// A wide light in the middle of the list: its maps begin later, and those after it later still.
static void make_mixed(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    add_floating(scene, random);
    add_lights(scene, random, 1);
    add_wide(scene, random);
    add_lights(scene, random, 1);
}

const SceneMaker LAB_TABLE[] = {
    {"lights one", make_one},
    {"lights several", make_several},
    {"lights lamp", make_lamp},
    {"lights lamp later", make_lamp_later},
    {"lights wide", make_wide},
    {"lights mixed", make_mixed},
    {0},
};
