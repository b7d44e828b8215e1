// Scenes of variance maps: a table that ends in the map, plates above each other, a fence far away, and
// slopes.
#include "scene/scene_parts.h"

static Light *add_light(Scene *scene, Random *random, float lowest, float highest) {
    LightKind kind = random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_DIRECTIONAL;
    vec3s place = random_int(random, 1, 5) == 1 ? vec3_make(0, 9, 0) : part_above(random, lowest, highest, 9);
    Light *light = part_light(scene, kind, place, vec3_make(0, 0, 0));
    light->near_plane = random_range(random, 2.5f, 4);
    light->far_plane = random_range(random, 13, 18);
    return light;
}

// Boxes and a ball over a floor that fills the map.
static void make_floor(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 9, random);
    part_casters(scene, random);
    add_light(scene, random, 50, 70);
}

// A box on a small table: the map's border sees nothing.
static void make_table(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 2.2f, random);
    part_box(scene, random_range(random, 0.5f, 0.8f), random);
    add_light(scene, random, 50, 70);
}

// Plates over wider ones: where their shadows lie on each other, the upper one's border still gives light.
static void make_plates(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 9, random);
    float turn = random_range(random, -20, 20);
    for (int i = 0; i < 3; i++) {
        float x = 1.3f * (float)i - 1.3f + random_range(random, -0.1f, 0.1f),
              low = random_range(random, 0.5f, 0.7f);
        part_object(scene, SHAPE_BOX, vec3_make(x, low, random_range(random, -0.2f, 0.2f)),
                    vec3_make(0.5f, 0.05f, 0.9f), turn, part_color(random));
        part_object(scene, SHAPE_BOX, vec3_make(x, low + random_range(random, 1, 1.4f), 0),
                    vec3_make(random_range(random, 0.14f, 0.2f), 0.05f, 0.8f), turn, part_color(random));
    }
    add_light(scene, random, 50, 62);
}

// A fence, seen from far away: many texels of the map in one pixel.
static void make_fence(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 9, random);
    float step = random_range(random, 0.34f, 0.4f), turn = random_range(random, -15, 15);
    mat4s turned = glms_rotate_make(glm_rad(turn), vec3_make(0, 1, 0));
    for (int i = 0; i < 11; i++)
        part_object(scene, SHAPE_BOX, glms_mat4_mulv3(turned, vec3_make(step * (float)(i - 5), 0.6f, 0), 1),
                    vec3_make(0.08f, 0.6f, 0.08f), turn, part_color(random));
    add_light(scene, random, 35, 50);
    vec3s away = glms_vec3_sub(scene->camera.eye, scene->camera.target);
    scene->camera.eye =
        glms_vec3_add(scene->camera.target, glms_vec3_scale(away, random_range(random, 1.6f, 2)));
    scene->camera.fov_y = glm_rad(30);
}

// Balls and tilted boxes under a low light: each texel holds many depths.
static void make_slopes(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 9, random);
    for (int i = 0; i < 3; i++) {
        float r = random_range(random, 0.4f, 0.6f);
        part_object(scene, i == 1 ? SHAPE_BOX : SHAPE_SPHERE,
                    vec3_make(1.3f * (float)i - 1.3f, r + random_range(random, 0, 0.4f),
                              random_range(random, -0.5f, 0.5f)),
                    vec3_make(r, r, r), random_range(random, 20, 70), part_color(random));
    }
    add_light(scene, random, 28, 40);
}

const SceneMaker LAB_TABLE[] = {{"variance floor", make_floor},   {"variance table", make_table},
                                {"variance plates", make_plates}, {"variance fence", make_fence},
                                {"variance slopes", make_slopes}, {0}};
