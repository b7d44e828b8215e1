// Scenes of ambient occlusion: corners and contacts under a bright sky.
#include "scene/scene_parts.h"

// Near, seen from above, with much ambient light and a weak lamp.
static void begin_sky(Scene *scene, Random *random, float distance) {
    part_begin(scene, random);
    vec3s target = vec3_make(random_range(random, -0.2f, 0.2f), random_range(random, 0.2f, 0.5f), 0);
    scene->camera.target = target;
    scene->camera.eye =
        part_orbit(target, random_range(random, -35, 35), random_range(random, 25, 45), distance);
    float sky = random_range(random, 0.6f, 0.75f);
    scene->ambient = vec3_make(sky, sky, sky * 1.1f);
    part_light(scene, LIGHT_DIRECTIONAL, part_above(random, 45, 65, 10), vec3_make(0, 0, 0));
    float lamp = random_range(random, 0.25f, 0.35f);
    scene->lights[0].color = vec3_make(lamp, lamp, lamp * 0.9f);
}

// A plane that stands at `middle` and faces +z, turned about +y.
static void add_wall(Scene *scene, vec3s middle, float half_width, float half_height, float turn,
                     Random *random) {
    Object *wall = part_object(scene, SHAPE_PLANE, middle, vec3_make(1, 1, 1), turn, part_color(random));
    wall->world_from_object = glms_rotate(wall->world_from_object, glm_rad(90), vec3_make(1, 0, 0));
    wall->world_from_object = glms_scale(wall->world_from_object, vec3_make(half_width, 1, half_height));
    wall->specular = 0;
}

// A floor before two walls that meet at right angles.
static void make_corner(Scene *scene, Random *random) {
    begin_sky(scene, random, 6.5f);
    float half = random_range(random, 1.5f, 2), a = random_range(random, 0.4f, 1),
          b = random_range(random, 0.4f, 1);
    float side = random_int(random, 0, 1) ? 1 : -1;
    part_floor(scene, half, random);
    add_wall(scene, vec3_make(0, a, -half), half, a, 0, random);
    add_wall(scene, vec3_make(-side * half, b, 0), half, b, side * 90, random);
}

// Boxes on a floor, near each other.
static void make_blocks(Scene *scene, Random *random) {
    begin_sky(scene, random, 5.5f);
    part_floor(scene, random_range(random, 1.5f, 1.8f), random);
    const float places[3][2] = {{-0.8f, -0.4f}, {0.1f, 0.5f}, {0.8f, -0.5f}};
    for (int i = 0; i < 3; i++) {
        float h = random_range(random, 0.3f, 0.7f);
        vec3s place = vec3_make(places[i][0] + random_range(random, -0.15f, 0.15f), h,
                                places[i][1] + random_range(random, -0.15f, 0.15f));
        vec3s half_size = vec3_make(random_range(random, 0.3f, 0.5f), h, random_range(random, 0.3f, 0.5f));
        part_object(scene, SHAPE_BOX, place, half_size, random_range(random, -40, 40), part_color(random));
    }
}

// A slab and a ball that hang over a floor.
static void make_canopy(Scene *scene, Random *random) {
    begin_sky(scene, random, 6);
    part_floor(scene, random_range(random, 1.5f, 1.8f), random);
    float side = random_int(random, 0, 1) ? 1 : -1, r = random_range(random, 0.35f, 0.55f);
    part_object(scene, SHAPE_BOX,
                vec3_make(side * random_range(random, 0.6f, 0.9f), random_range(random, 0.8f, 1.1f),
                          random_range(random, -0.5f, 0.1f)),
                vec3_make(random_range(random, 0.5f, 0.7f), 0.1f, random_range(random, 0.5f, 0.8f)),
                random_range(random, 10, 80), part_color(random));
    part_object(scene, SHAPE_SPHERE,
                vec3_make(-side * random_range(random, 0.5f, 0.8f), r + random_range(random, 0, 0.2f),
                          random_range(random, -0.3f, 0.5f)),
                vec3_make(r, r, r), 0, part_color(random));
}

// Sheets over a floor, so close to it or so high that all rays of a texel hit one within half a unit, or none
// does, whatever their directions: the sheets end where texels of a third of a unit do.
static void make_sheets(Scene *scene, Random *random) {
    begin_sky(scene, random, 5.5f);
    part_floor(scene, 1.5f, random);
    for (int i = 0; i < 4; i++) {
        float width = (float)random_int(random, 1, 3), depth = (float)random_int(random, 2, 3);
        float left = (float)random_int(random, 0, 1) + (i % 2 ? 0.5f : -4.5f),
              back = (float)random_int(random, 0, 1) + (i / 2 ? 0.5f : -4.5f);
        vec3s middle = vec3_make((left + width / 2) / 3, i == 0 ? 0.8f : 0.006f, (back + depth / 2) / 3);
        part_object(scene, SHAPE_PLANE, middle, vec3_make(width / 6, 1, depth / 6), 0, part_color(random));
    }
}

// Posts far in front of a wall, as the camera sees them.
static void make_posts(Scene *scene, Random *random) {
    begin_sky(scene, random, 5.5f);
    float back = random_range(random, 1.8f, 2.4f);
    part_floor(scene, back, random);
    add_wall(scene, vec3_make(0, 1.2f, -back), back, 1.2f, 0, random);
    for (int i = -1; i <= 1; i++) {
        float h = random_range(random, 0.6f, 1), w = random_range(random, 0.1f, 0.2f);
        part_object(
            scene, SHAPE_BOX,
            vec3_make(0.9f * (float)i + random_range(random, -0.2f, 0.2f), h, random_range(random, 0.2f, 1)),
            vec3_make(w, h, w), random_range(random, 0, 45), part_color(random));
    }
}

const SceneMaker LAB_TABLE[] = {
    {"sky corner", make_corner}, {"sky blocks", make_blocks}, {"sky canopy", make_canopy},
    {"sky sheets", make_sheets}, {"sky posts", make_posts},   {0},
};
