// Scenes of the edges of shadows.
#include "scene/scene_parts.h"

static const float SLANT_GAP = 0.42f;

// A plate before the wall, parallel to it, `gap` away and turned about its own normal. It has no thickness:
// its narrow sides would be steep for the light, and their bias large.
static void add_plate(Scene *scene, Random *random, float x, float y, float gap) {
    vec3s center =
        vec3_make(x + random_range(random, -0.3f, 0.3f), y + random_range(random, -0.25f, 0.25f), gap);
    vec3s half_size = vec3_make(random_range(random, 0.5f, 0.8f), 1, random_range(random, 0.25f, 0.4f));
    Object *plate = part_object(scene, SHAPE_PLANE, center, half_size, 0, part_color(random));
    mat4s turned =
        glms_rotate(glms_translate_make(center), glm_rad(random_range(random, 0, 180)), vec3_make(0, 0, 1));
    plate->world_from_object = glms_scale(glms_rotate(turned, glm_rad(90), vec3_make(1, 0, 0)), half_size);
}

// The light falls straight on the wall and on the plates: their depth in the map does not change from texel
// to texel, so that no bias is needed and the edge of the shadow shows the filter alone.
static void make_plates(Scene *scene, Random *random, LightKind kind) {
    part_begin(scene, random);
    Object *wall = part_floor(scene, 3.4f, random);
    wall->world_from_object =
        glms_mat4_mul(glms_rotate_make(glm_rad(90), vec3_make(1, 0, 0)), wall->world_from_object);
    for (int i = 0; i < 4; i++)
        add_plate(scene, random, i % 2 ? 1.0f : -1.0f, i / 2 ? 0.75f : -0.75f,
                  random_range(random, 1.3f, 2.0f));
    vec3s aim = vec3_make(random_range(random, -0.2f, 0.2f), random_range(random, -0.2f, 0.2f), 0);
    Light *light = part_light(scene, kind, vec3_make(aim.x, aim.y, 10), aim);
    light->fov_y = glm_rad(36);
    light->half_size = 3.2f;
    float side = random_int(random, 0, 1) ? 1 : -1;
    scene->camera.target = vec3_make(-0.5f * side, 0, 0.5f);
    scene->camera.eye = part_orbit(scene->camera.target, side * random_range(random, 32, 42),
                                   random_range(random, 8, 18), random_range(random, 5.5f, 6.5f));
}

static void make_plates_sun(Scene *scene, Random *random) {
    make_plates(scene, random, LIGHT_DIRECTIONAL);
}

static void make_plates_spot(Scene *scene, Random *random) {
    make_plates(scene, random, LIGHT_SPOT);
}

// A wall, and plates close before it, under a light whose depth grows along both axes of the map alike: the
// wall then needs all the bias that a filter may ask for, and the plates keep their shadows up to one and a
// half times that much. (A plate's own slope counts in the same way.)
static void make_slant(Scene *scene, Random *random, LightKind kind) {
    part_begin(scene, random);
    Object *wall = part_floor(scene, 2.6f, random);
    wall->world_from_object =
        glms_mat4_mul(glms_rotate_make(glm_rad(90), vec3_make(1, 0, 0)), wall->world_from_object);
    for (int i = 0; i < 4; i++)
        add_plate(scene, random, i % 2 ? 1.1f : -1.1f, i / 2 ? 0.85f : -0.85f, SLANT_GAP);
    float z = random_range(random, 0.72f, 0.78f), y = sqrtf((1 - z * z) / (1 + z * z));
    float side = random_int(random, 0, 1) ? 1 : -1, up = random_int(random, 0, 1) ? 1 : -1;
    vec3s to_light = vec3_make(side * y * z, up * y, z);
    Light *light = part_light(scene, kind, glms_vec3_scale(to_light, 10), vec3_make(0, 0, 0));
    light->fov_y = glm_rad(40);
    light->half_size = 3.6f;
    scene->camera.target = vec3_make(0.2f * side, 0, 0);
    scene->camera.eye = part_orbit(scene->camera.target, -side * random_range(random, 20, 35),
                                   -up * random_range(random, 8, 18), random_range(random, 5.5f, 6.5f));
}

static void make_slant_sun(Scene *scene, Random *random) {
    make_slant(scene, random, LIGHT_DIRECTIONAL);
}

static void make_slant_spot(Scene *scene, Random *random) {
    make_slant(scene, random, LIGHT_SPOT);
}

// Posts and a sphere on a floor under a slanting light.
static void make_fence(Scene *scene, Random *random, LightKind kind) {
    part_begin(scene, random);
    part_floor(scene, 3.4f, random);
    scene->camera.eye = glms_vec3_scale(scene->camera.eye, 0.75f);
    vec3s color = part_color(random);
    float turn = random_range(random, -25, 25), along = glm_rad(turn);
    for (int i = 0; i < 4; i++) {
        float x = -1.5f + 0.8f * (float)i, h = random_range(random, 0.6f, 0.9f);
        part_object(scene, SHAPE_BOX, vec3_make(x * cosf(along), h, -x * sinf(along) - 0.4f),
                    vec3_make(0.17f, h, 0.17f), turn + random_range(random, 0, 40), color);
    }
    float r = random_range(random, 0.35f, 0.5f);
    part_object(scene, SHAPE_SPHERE,
                vec3_make(random_range(random, 1.6f, 2.0f), r + 0.2f, random_range(random, -0.5f, 0.5f)),
                vec3_make(r, r, r), 0, part_color(random));
    Light *light = part_light(scene, kind, part_above(random, 40, 52, 10), vec3_make(0, 0, 0));
    light->half_size = 3.6f;
    light->fov_y = glm_rad(44);
}

static void make_fence_sun(Scene *scene, Random *random) {
    make_fence(scene, random, LIGHT_DIRECTIONAL);
}

static void make_fence_spot(Scene *scene, Random *random) {
    make_fence(scene, random, LIGHT_SPOT);
}

const SceneMaker LAB_TABLE[] = {
    {"plates sun", make_plates_sun},
    {"plates spot", make_plates_spot},
    {"slant sun", make_slant_sun},
    {"slant spot", make_slant_spot},
    {"fence sun", make_fence_sun},
    {"fence spot", make_fence_spot},
    {0},
};
