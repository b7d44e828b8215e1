// Scenes of framebuffers and basic shadow maps.
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

static void make_table_spot(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    part_light(scene, LIGHT_SPOT, part_above(random, 45, 70, random_range(random, 9, 10)),
               vec3_make(0, 0, 0));
}

static void make_table_sun(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    part_light(scene, LIGHT_DIRECTIONAL, part_above(random, 40, 70, random_range(random, 9, 10)),
               vec3_make(0, 0, 0));
}

// The map covers only the middle of the floor, with a caster that its edge cuts.
static void make_wide_floor(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 12, random);
    part_casters(scene, random);
    bool spot = random_int(random, 0, 1) == 1;
    part_light(scene, spot ? LIGHT_SPOT : LIGHT_DIRECTIONAL, part_above(random, 50, 65, 10),
               vec3_make(0, 0, 0));
    scene->lights[0].fov_y = glm_rad(random_range(random, 14, 16));
    scene->lights[0].half_size = random_range(random, 1.1f, 1.3f);
}

// The floor passes through the far plane of the light: what lies behind it has a depth above 1.
static void make_far_floor(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 4, random);
    part_box(scene, random_range(random, 0.5f, 0.8f), random);
    bool spot = random_int(random, 0, 1) == 1;
    part_light(scene, spot ? LIGHT_SPOT : LIGHT_DIRECTIONAL, part_above(random, 35, 45, 10),
               vec3_make(0, 0, 0));
    scene->lights[0].far_plane = random_range(random, 10.2f, 10.8f);
    scene->lights[0].half_size = 6;
}

// The lamp hangs low over the floor and looks to the side: half of the floor lies behind it.
static void make_behind(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 4, random);
    float side = random_int(random, 0, 1) ? 1 : -1;
    float height = random_range(random, 0.9f, 1.2f);
    vec3s lamp = vec3_make(side * random_range(random, 0, 0.4f), height, random_range(random, -0.3f, 0.3f));
    part_light(scene, LIGHT_SPOT, lamp, vec3_make(lamp.x + side * 2, height - 0.1f, lamp.z));
    scene->lights[0].fov_y = glm_rad(90);
    scene->lights[0].near_plane = 0.2f;
    scene->lights[0].far_plane = 12;
}

const SceneMaker scenes_table[] = {
    {"studio", make_studio},
    {"table spot", make_table_spot},
    {"table sun", make_table_sun},
    {"wide floor", make_wide_floor},
    {"far floor", make_far_floor},
    {"behind", make_behind},
    {0},
};
