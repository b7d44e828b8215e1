// A scene of framebuffers: a studio with a screen in it.
#include "scene/scene_parts.h"

// A screen that leans back a little, before a dark panel that is its frame.
static void add_screen(Scene *scene, Random *random) {
    mat4s placed = glms_translate_make(vec3_make(random_range(random, -0.4f, 0.4f), 1.5f, -2));
    placed = glms_rotate(placed, glm_rad(random_range(random, 70, 85)), vec3_make(1, 0, 0));
    Object *panel = part_object(scene, SHAPE_BOX, vec3_make(0, 0, 0), vec3_make(1, 1, 1), 0,
                                vec3_make(0.05f, 0.05f, 0.06f));
    panel->world_from_object =
        glms_scale(glms_translate(placed, vec3_make(0, -0.06f, 0)), vec3_make(2, 0.05f, 1.4f));
    Object *screen =
        part_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(1, 1, 1), 0, part_color(random));
    screen->world_from_object = glms_scale(placed, vec3_make(1.9f, 1, 1.3f));
    screen->is_screen = 1;
}

static void make_studio(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_casters(scene, random);
    part_floor(scene, 6, random); // last, so that it hides the rest where the depth test is missing
    part_light(scene, LIGHT_DIRECTIONAL, part_above(random, 45, 65, 10), vec3_make(0, 0, 0));
    scene->camera.target.y = 1.2f;
    add_screen(scene, random);
    vec3s middle = vec3_make(0, 0.5f, 0.5f);
    float side = random_int(random, 0, 1) ? 1 : -1; // the panel hides nothing from there
    scene->second_camera.eye =
        part_orbit(middle, side * random_range(random, 65, 100), random_range(random, 15, 40), 6);
    scene->second_camera.target = middle;
    scene->second_camera.near_plane = random_range(random, 2.5f, 3);
    scene->second_camera.far_plane = random_range(random, 12, 14);
}

// The second camera stands low, so that it sees the background above the floor, and its near plane is so near
// that a depth buffer of 16 bits cannot tell the floor from what stands on it.
static void make_studio_low(Scene *scene, Random *random) {
    make_studio(scene, random);
    float side = scene->second_camera.eye.x > 0 ? 1 : -1;
    scene->second_camera.eye = part_orbit(scene->second_camera.target, side * random_range(random, 65, 100),
                                          random_range(random, 8, 14), random_range(random, 5, 6));
    scene->second_camera.near_plane = random_range(random, 0.003f, 0.004f);
}

const SceneMaker LAB_TABLE[] = {
    {"studio", make_studio},
    {"studio low", make_studio_low},
    {0},
};
