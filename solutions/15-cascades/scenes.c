// Scenes of cascades: a long floor with few casters, each so much larger as it is farther away; slabs over
// it; and plates high above.
#include "scene/scene_parts.h"

enum { CASTERS = 5, SLABS = 4, PLATES = 3 };
#define NEAREST 1.7F // where the floor is seen: eye heights before the eye

enum { GROUND = 12 };

// How the camera stands: its height over the floor, and the turn about +y (degrees) of where it looks.
typedef struct Stand {
    float height, turn;
} Stand;

// The floor lies far above or far below the world's origin, so that a map around the origin holds none of it.
static float ground(const Stand *stand) {
    return stand->turn > 0 ? GROUND : -GROUND;
}

// A place `ahead` of the camera's foot and `aside` to its right.
static vec3s place(const Stand *stand, float aside, float height, float ahead) {
    mat4s turned = glms_rotate_make(glm_rad(stand->turn), vec3_make(0, 1, 0));
    return glms_mat4_mulv3(turned, vec3_make(aside, height + ground(stand), -ahead), 1);
}

// A floor up to the horizon, whose normal is not of length 1; the camera is low and looks along it, or high
// and looks down.
static Stand begin(Scene *scene, Random *random) {
    part_begin(scene, random);
    bool high = random_int(random, 0, 2) == 0;
    Stand stand = {high ? random_range(random, 3, 5) : random_range(random, 1, 1.6f),
                   random_range(random, -180, 180)};
    float pitch = high ? random_range(random, 20, 28) : random_range(random, 12, 18);
    scene->camera.eye = place(&stand, 0, stand.height, 0);
    scene->camera.target = place(&stand, 0, stand.height - tanf(glm_rad(pitch)), 1);
    scene->camera.fov_y = glm_rad(random_range(random, 42, 56));
    scene->camera.near_plane = random_range(random, 0.6f, 1.2f);
    scene->camera.far_plane = random_range(random, 40, 60);
    Object *floor = part_floor(scene, 80, random);
    floor->world_from_object = glms_scale(
        glms_translate(floor->world_from_object, vec3_make(0, ground(&stand), 0)), vec3_make(1, 0.6f, 1));
    return stand;
}

// From anywhere, at times straight above.
static Light *add_sun(Scene *scene, const Stand *stand, Random *random, float lowest, float highest) {
    vec3s target = vec3_make(random_range(random, -3, 3), ground(stand), random_range(random, -3, 3));
    float azimuth = random_range(random, 0, 360), elevation = random_range(random, lowest, highest);
    vec3s above = part_orbit(target, azimuth, elevation, 12);
    if (random_int(random, 1, 5) == 1)
        above = vec3_make(target.x, target.y + 12, target.z);
    return part_light(scene, LIGHT_DIRECTIONAL, above, target);
}

// The distances grow by the same factor from one to the next.
static float distance_of(const Scene *scene, const Stand *stand, int i, int count) {
    float nearest = NEAREST * stand->height, ratio = 0.6f * scene->camera.far_plane / nearest;
    return nearest * powf(ratio, (float)i / (float)(count - 1));
}

static void make_floor(Scene *scene, Random *random) {
    Stand stand = begin(scene, random);
    for (int i = 0; i < CASTERS; i++) {
        float ahead = distance_of(scene, &stand, i, CASTERS) * random_range(random, 0.95f, 1.1f);
        float side = i % 2 ? 1 : -1, aside = side * ahead * random_range(random, 0.06f, 0.16f);
        float wide = ahead * random_range(random, 0.03f, 0.05f),
              high = ahead * random_range(random, 0.06f, 0.1f);
        if (i % 3 == 1)
            part_object(scene, SHAPE_SPHERE, place(&stand, aside, 1.2f * high, ahead),
                        vec3_make(high, high, high), 0, part_color(random));
        else
            part_object(scene, SHAPE_BOX, place(&stand, aside, high, ahead), vec3_make(wide, high, wide),
                        random_range(random, 0, 90), part_color(random));
    }
    add_sun(scene, &stand, random, 30, 60);
}

// Slabs over the floor, and the sun so high that all of the floor is in the spheres' depths, or behind them.
static void make_noon(Scene *scene, Random *random) {
    Stand stand = begin(scene, random);
    for (int i = 0; i < SLABS; i++) {
        float ahead = distance_of(scene, &stand, i, SLABS), side = i % 2 ? 1 : -1;
        float high = ahead * random_range(random, 0.06f, 0.12f),
              half = ahead * random_range(random, 0.1f, 0.15f);
        part_object(scene, SHAPE_BOX,
                    place(&stand, side * ahead * random_range(random, 0.08f, 0.16f), high, ahead),
                    vec3_make(half, 0.01f * ahead, half), random_range(random, 0, 90), part_color(random));
    }
    add_sun(scene, &stand, random, 74, 85);
}

// Plates so far towards the sun that they are outside of the spheres of the slices that they darken.
static void make_plates(Scene *scene, Random *random) {
    Stand stand = begin(scene, random);
    const Light *sun = add_sun(scene, &stand, random, 45, 70);
    vec3s to_sun = glms_vec3_normalize(glms_vec3_sub(sun->position, sun->target));
    for (int i = 0; i < PLATES; i++) {
        float ahead = distance_of(scene, &stand, i, PLATES + 1), side = i % 2 ? 1 : -1;
        vec3s dark = place(&stand, side * ahead * random_range(random, 0, 0.1f), 0, ahead);
        float away = ahead * random_range(random, 3, 4), half = ahead * random_range(random, 0.1f, 0.16f);
        part_object(scene, SHAPE_BOX, glms_vec3_muladds(to_sun, away, dark), vec3_make(half, 0.05f, half),
                    random_range(random, 0, 90), part_color(random));
    }
}

const SceneMaker LAB_TABLE[] = {
    {"cascade floor", make_floor}, {"cascade noon", make_noon}, {"cascade plates", make_plates}, {0}};
