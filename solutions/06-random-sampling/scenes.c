// Scenes of random sampling: wide penumbrae, and shadows smaller than the disc of samples.
#include "scene/scene_parts.h"

static LightKind any_kind(Random *random) {
    return random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_DIRECTIONAL;
}

// A light steep enough that shadows stay in the picture, narrow enough that a disc of a few texels is wide.
static Light *add_lamp(Scene *scene, Random *random, LightKind kind, float lowest, float highest) {
    Light *light = part_light(scene, kind, part_above(random, lowest, highest, 10), vec3_make(0, 0, 0));
    light->fov_y = glm_rad(46);
    light->half_size = 4.2f;
    return light;
}

// Where a spot light's ray through `point` meets the floor.
static vec3s on_floor(const Light *light, vec3s point) {
    vec3s ray = glms_vec3_sub(point, light->position);
    return glms_vec3_sub(point, glms_vec3_scale(ray, point.y / ray.y));
}

// Thick beams side by side above the floor: their shadows are little but penumbra.
static void make_beams(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    float turn = random_range(random, -60, 60), step = random_range(random, 1.2f, 1.5f);
    mat4s turned = glms_rotate_make(glm_rad(turn), vec3_make(0, 1, 0));
    for (int i = -1; i <= 1; i++) {
        vec3s center =
            vec3_make(step * (float)i, random_range(random, 1.1f, 1.5f), random_range(random, -0.5f, 0.5f));
        part_object(scene, SHAPE_BOX, glms_mat4_mulv3(turned, center, 1),
                    vec3_make(random_range(random, 0.2f, 0.3f), 0.2f, random_range(random, 1.2f, 1.6f)), turn,
                    part_color(random));
    }
    add_lamp(scene, random, any_kind(random), 50, 65);
}

// The middle of the picture lies at the edge of a shadow.
static void make_edge(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    float turn = random_range(random, 0, 360);
    vec3s center = vec3_make(random_range(random, -0.5f, 0.5f), random_range(random, 1.2f, 1.6f), 0);
    vec3s half_size = vec3_make(random_range(random, 0.5f, 0.9f), 0.3f, random_range(random, 0.5f, 0.9f));
    const Object *box = part_object(scene, SHAPE_BOX, center, half_size, turn, part_color(random));
    const Light *light = add_lamp(scene, random, LIGHT_SPOT, 50, 70);
    vec3s edge = vec3_make(random_range(random, 0.7f, 1), -1, random_range(random, -1, 1));
    scene->camera.target = on_floor(light, glms_mat4_mulv3(box->world_from_object, edge, 1));
}

// Small boxes above the floor: their shadows are narrower than the disc.
static void add_pebbles(Scene *scene, Random *random, float side) {
    for (int i = 0; i < 6; i++) {
        int row = i / 2;
        float r = random_range(random, 0.1f, 0.16f);
        float x = 0.4f + 1.1f * (float)(i % 2), z = 1.3f * (float)row - 1.2f;
        vec3s center = vec3_make(side * (x + random_range(random, -0.15f, 0.15f)),
                                 random_range(random, 0.5f, 1.1f), z + random_range(random, -0.2f, 0.2f));
        part_object(scene, SHAPE_BOX, center, vec3_make(r, r, r), random_range(random, 0, 90),
                    part_color(random));
    }
}

// Two slats across two above the floor: a small window, narrower than the disc, in a large shadow.
static void add_window(Scene *scene, Random *random, float side) {
    float turn = random_range(random, -10, 10), height = random_range(random, 1, 1.3f);
    const float gap = 0.2f, step = 1.05f, half_width = step / 2 - gap, half_length = step + half_width;
    mat4s turned = glms_rotate_make(glm_rad(turn), vec3_make(0, 1, 0));
    for (int i = 0; i < 2; i++) {
        float from_middle = step * ((float)i - 0.5f);
        vec3s along = vec3_make(1.6f * side + from_middle, height, -0.6f);
        vec3s across = vec3_make(1.6f * side, height + 0.2f, from_middle - 0.6f);
        part_object(scene, SHAPE_BOX, glms_mat4_mulv3(turned, along, 1),
                    vec3_make(half_width, 0.1f, half_length), turn, part_color(random));
        part_object(scene, SHAPE_BOX, glms_mat4_mulv3(turned, across, 1),
                    vec3_make(half_length, 0.1f, half_width), turn, part_color(random));
    }
}

static void make_pebbles(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    float side = random_int(random, 0, 1) ? 1 : -1;
    add_pebbles(scene, random, side);
    add_window(scene, random, -side);
    add_lamp(scene, random, any_kind(random), 45, 60);
}

const SceneMaker LAB_TABLE[] = {
    {"beams", make_beams},
    {"edge", make_edge},
    {"pebbles", make_pebbles},
    {0},
};
