// Scenes of basic shadow maps.
#include "scene/scene_parts.h"

// Lets the light look at a point beside the origin, near enough for the table to stay in its map.
static void aim(Light *light, Random *random) {
    light->target = vec3_make(random_range(random, 0.3f, 0.7f), random_range(random, 0, 0.4f),
                              random_range(random, -0.7f, 0.7f));
    if (random_int(random, 0, 1))
        light->target.x = -light->target.x;
}

static void make_table_spot(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    aim(part_light(scene, LIGHT_SPOT, part_above(random, 45, 70, random_range(random, 9, 10)),
                   vec3_make(0, 0, 0)),
        random);
}

// The same with a floor whose highlight lies in the shadows.
static void make_table_shine(Scene *scene, Random *random) {
    make_table_spot(scene, random);
    scene->objects[0].specular = random_range(random, 0.7f, 0.9f);
    scene->objects[0].shininess = random_range(random, 4, 7);
}

// The lamp hangs straight above the point that it looks at, over a floor that slopes: a level one has one
// depth.
static void make_table_noon(Scene *scene, Random *random) {
    part_begin(scene, random);
    Object *floor = part_floor(scene, 6, random);
    float slope = random_range(random, 0.4f, 0.6f), side = random_int(random, 0, 1) ? 1 : -1;
    floor->world_from_object = glms_mat4_mul(
        glms_rotate_make(slope, vec3_make(side, 0, random_range(random, -1, 1))), floor->world_from_object);
    part_casters(scene, random);
    Light *light = part_light(scene, LIGHT_SPOT, vec3_make(0, 9, 0), vec3_make(0, 0, 0));
    aim(light, random);
    light->position = light->target;
    light->position.y = random_range(random, 9, 10);
}

static void make_table_sun(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
    part_casters(scene, random);
    aim(part_light(scene, LIGHT_DIRECTIONAL, part_above(random, 40, 70, random_range(random, 9, 10)),
                   vec3_make(0, 0, 0)),
        random);
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
    scene->lights[0].half_size = 4.2f; // the corners of the floor lie outside of the map
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

const SceneMaker LAB_TABLE[] = {
    {"table spot", make_table_spot},   {"table noon", make_table_noon},
    {"table shine", make_table_shine}, {"table sun", make_table_sun},
    {"wide floor", make_wide_floor},   {"far floor", make_far_floor},
    {"behind", make_behind},           {0},
};
