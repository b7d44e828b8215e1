// Scenes of planar shadows: receivers are planes; boxes and spheres stand or float over them.
#include "scene/scene_parts.h"

enum { UNDER_THE_LAMP = 5 };

// A place for a light, mostly behind the casters, at times straight above them.
static vec3s place_light(Random *random, float lowest, float highest, float distance) {
    bool overhead = random_int(random, 0, UNDER_THE_LAMP) == 0;
    vec3s place = part_above(random, lowest, highest, distance);
    return overhead ? vec3_make(0, place.y, 0) : place;
}

// A lamp that shines to all sides, or a spot light: both throw the same shadows.
static Light *lamp_at(Scene *scene, vec3s position) {
    LightKind kind = position.x > 0 ? LIGHT_SPOT : LIGHT_POINT;
    return part_light(scene, kind, position, vec3_make(0, 0.3f, 0));
}

// A sun that shines from there to a place beside the origin: its direction is a difference.
static Light *sun_from(Scene *scene, Random *random, vec3s position) {
    vec3s aside = vec3_make(random_range(random, -1.5f, 1.5f), 0, random_range(random, -1.5f, 1.5f));
    return part_light(scene, LIGHT_DIRECTIONAL, glms_vec3_add(position, aside), aside);
}

// Tilts a receiver by degrees about x and z, around its middle, and lifts it.
static void tilt(Object *receiver, float about_x, float about_z, float lift) {
    mat4s turned =
        glms_rotate(glms_translate_make(vec3_make(0, lift, 0)), glm_rad(about_x), vec3_make(1, 0, 0));
    turned = glms_rotate(turned, glm_rad(about_z), vec3_make(0, 0, 1));
    receiver->world_from_object = glms_mat4_mul(turned, receiver->world_from_object);
}

// Boxes and spheres in a row from left to right, their middles between two heights.
static void float_casters(Scene *scene, Random *random, int count, float lowest, float highest) {
    for (int i = 0; i < count; i++) {
        float r = random_range(random, 0.3f, 0.5f), x = 2.8f * ((float)i + 0.5f) / (float)count - 1.4f;
        part_object(scene, (i + random_int(random, 0, 1)) % 2 ? SHAPE_BOX : SHAPE_SPHERE,
                    vec3_make(x, random_range(random, lowest, highest), random_range(random, -0.7f, 0.7f)),
                    vec3_make(r, r * random_range(random, 0.5f, 1), r), random_range(random, 0, 90),
                    part_color(random));
    }
}

// The light behind the casters: what the camera sees of them is mostly dark, and so is a screen.
static void make_own(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_casters(scene, random);
    Object *screen =
        part_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(0.8f, 1, 0.8f), 0, part_color(random));
    tilt(screen, random_range(random, 70, 100), random_range(random, -30, 30), 0.9f);
    vec3s place = part_above(random, 25, 55, 9);
    if (random_int(random, 0, 1)) {
        lamp_at(scene, place);
    } else {
        sun_from(scene, random, place);
    }
}

// A sheet with this normal, which the camera sees well.
static Object *add_sheet(Scene *scene, Random *random, vec3s middle, vec3s normal) {
    float size = random_range(random, 0.5f, 0.8f);
    vec3s right = glms_vec3_normalize(glms_vec3_cross(vec3_make(0.2f, 1, 0.1f), normal));
    Object *sheet = part_object(scene, SHAPE_PLANE, middle, vec3_make(1, 1, 1), 0, part_color(random));
    mat4s *placed = &sheet->world_from_object;
    placed->col[0] = glms_vec4(glms_vec3_scale(right, size), 0);
    placed->col[1] = glms_vec4(normal, 0);
    placed->col[2] = glms_vec4(glms_vec3_scale(glms_vec3_cross(right, normal), size), 0);
    return sheet;
}

// Two sheets that the sun grazes, one from before and one from behind, on two sides of the middle. The sun is
// so strong that even so little of its light is seen.
static void make_grazing(Scene *scene, Random *random) {
    part_begin(scene, random);
    vec3s view = glms_vec3_normalize(scene->camera.eye);
    vec3s across = glms_vec3_normalize(glms_vec3_cross(vec3_make(0, 1, 0), view));
    vec3s up = glms_vec3_cross(view, across);
    float side = random_int(random, 0, 1) ? 1 : -1, turn = random_range(random, 0, 2 * GLM_PIf);
    vec3s sun =
        part_orbit(vec3_make(0, 0, 0), glm_deg(atan2f(view.x, view.z)) + side * random_range(random, 60, 90),
                   random_range(random, 15, 45), 9);
    vec3s toward = glms_vec3_normalize(sun);
    vec3s best = glms_vec3_normalize(glms_vec3_muladds(toward, -glms_vec3_dot(toward, view), view));
    vec3s aside = glms_vec3_add(glms_vec3_scale(across, cosf(turn)), glms_vec3_scale(up, sinf(turn)));
    for (int i = 0; i < 2; i++) {
        float facing = random_range(random, 0.006f, 0.01f) * (i ? 1 : -1);
        vec3s normal = glms_vec3_scale(best, sqrtf(1 - facing * facing));
        float away = random_range(random, 0.8f, 1.1f) * (i ? 1 : -1);
        add_sheet(scene, random, glms_vec3_scale(aside, away), glms_vec3_muladds(toward, facing, normal))
            ->specular = 0;
    }
    sun_from(scene, random, sun)->color = vec3_make(120, 120, 112);
}

// A sun straight above a level floor at any height.
static void make_noon(Scene *scene, Random *random) {
    part_begin(scene, random);
    float lift = random_range(random, 0.3f, 0.8f) * (random_int(random, 0, 1) ? 1 : -1);
    tilt(part_floor(scene, 6, random), 0, 0, lift);
    float_casters(scene, random, 4, lift + 0.8f, lift + 2);
    vec3s sun = vec3_make(random_range(random, -1, 1), 9, random_range(random, -1, 1));
    part_light(scene, LIGHT_DIRECTIONAL, sun, vec3_make(sun.x, 0, sun.z));
}

static void make_slope(Scene *scene, Random *random) {
    part_begin(scene, random);
    tilt(part_floor(scene, 6, random), random_range(random, -15, 15), random_range(random, -15, 15),
         random_range(random, -0.6f, 0.2f));
    float_casters(scene, random, 4, 1.2f, 2.2f);
}

static void make_lamp(Scene *scene, Random *random) {
    make_slope(scene, random);
    lamp_at(scene, place_light(random, 55, 80, random_range(random, 6, 9)));
}

static void make_sun(Scene *scene, Random *random) {
    make_slope(scene, random);
    sun_from(scene, random, place_light(random, 40, 75, random_range(random, 6, 12)));
}

// Casters over the lamp and under the floor, each on a line through the lamp and a place that one sees; and
// some in the floor and over it.
static void make_between(Scene *scene, Random *random) {
    part_begin(scene, random);
    float lift = random_range(random, 0.3f, 0.6f) * (random_int(random, 0, 1) ? 1 : -1);
    tilt(part_floor(scene, 6, random), random_range(random, -10, 10), random_range(random, -10, 10), lift);
    float_casters(scene, random, 2, lift - 0.3f, lift + 0.9f);
    vec3s lamp = place_light(random, 45, 75, random_range(random, 3.2f, 4));
    for (int i = 0; i < 3; i++) {
        float r = random_range(random, 0.35f, 0.5f);
        vec3s seen = vec3_make(1.2f * (float)i - 1.8f, lift, random_range(random, 0.9f, 1.9f));
        float far = i % 2 ? random_range(random, -0.5f, -0.35f) : random_range(random, 1.25f, 1.4f);
        part_object(scene, SHAPE_BOX, glms_vec3_lerp(lamp, seen, far), vec3_make(r, 0.15f, r),
                    random_range(random, 0, 90), part_color(random));
    }
    if (random_int(random, 0, 2)) {
        lamp_at(scene, lamp);
    } else {
        sun_from(scene, random, lamp);
    }
}

// One large floor and what floats low over it, so that only depth matters: nothing touches its shadow.
static void make_low(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 7, random);
    float_casters(scene, random, 3, 0.65f, 1);
    vec3s place = place_light(random, 40, 65, random_range(random, 7, 9));
    if (random_int(random, 0, 1)) {
        lamp_at(scene, place);
    } else {
        sun_from(scene, random, place);
    }
}

// A small table over a floor, and a wall: each takes only its own part of a shadow.
static void make_table(Scene *scene, Random *random) {
    part_begin(scene, random);
    tilt(part_floor(scene, 7, random), 0, 0, -0.9f);
    Object *table = part_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0),
                                vec3_make(random_range(random, 0.9f, 1.3f), 1, random_range(random, 0.7f, 1)),
                                random_range(random, 0, 90), part_color(random));
    tilt(table, random_range(random, -8, 8), random_range(random, -8, 8), 0);
    float_casters(scene, random, 3, 0.8f, 1.3f);
    vec3s lamp = place_light(random, 40, 60, random_range(random, 5, 7));
    Object *wall =
        part_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(3, 1, 1.5f), 0, part_color(random));
    tilt(wall, 90, 0, 0.6f);
    wall->world_from_object.col[3].z = -2.6f;
    lamp.z = fabsf(lamp.z); // before the wall, so in front of the casters
    part_object(scene, SHAPE_BOX, vec3_make(0, -0.6f, -0.3f), vec3_make(0.5f, 0.25f, 0.4f),
                random_range(random, 0, 90),
                part_color(random)); // under the table, hidden by it
    lamp_at(scene, lamp);
}

// Casters over each other: their shadows overlap.
static void make_glass(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 7, random);
    vec3s lamp = place_light(random, 50, 75, random_range(random, 8, 9));
    for (int i = 0; i < 4; i++) {
        float r = random_range(random, 0.4f, 0.6f), height = 0.6f + 0.8f * (float)i;
        vec3s center = glms_vec3_scale(lamp, height / lamp.y);
        center.x += random_range(random, -0.7f, 0.7f);
        center.z += random_range(random, -0.4f, 0.4f);
        part_object(scene, i % 2 ? SHAPE_SPHERE : SHAPE_BOX, center, vec3_make(r, 0.3f, r),
                    random_range(random, 0, 90), part_color(random));
    }
    lamp_at(scene, lamp);
}

static void make_wide(Scene *scene, Random *random) {
    part_begin(scene, random);
    tilt(part_floor(scene, 7, random), random_range(random, -8, 8), random_range(random, -8, 8), 0);
    float_casters(scene, random, 3, 1.2f, 2);
    lamp_at(scene, place_light(random, 50, 75, random_range(random, 6, 8)))->extent =
        random_range(random, 0.5f, 0.9f);
}

const SceneMaker LAB_TABLE[] = {
    {"planar own", make_own},
    {"planar grazing", make_grazing},
    {"planar noon", make_noon},
    {"planar lamp", make_lamp},
    {"planar sun", make_sun},
    {"planar between", make_between},
    {"planar low", make_low},
    {"planar table", make_table},
    {"planar glass", make_glass},
    {"planar wide", make_wide},
    {0},
};
