// Scenes of a square lamp: plates at several heights, posts that touch the floor, and things too small to be
// found.
#include "scene/scene_parts.h"

enum { PLATES = 4 };
enum { LOW = 3, MIDDLE = 1 };
#define GIVEN_EXTENT 0.75F // of the lamp, as the skeleton has it

// The lamp is a spot light whose map sees all of the table.
static Light *add_lamp(Scene *scene, Random *random, float extent) {
    vec3s aside = vec3_make(random_range(random, -0.3f, 0.3f), 0, random_range(random, -0.3f, 0.3f));
    vec3s above = random_int(random, 1, 5) == 1 ? vec3_make(0, 9, 0) : part_above(random, 55, 75, 9);
    Light *light = part_light(scene, LIGHT_SPOT, glms_vec3_add(above, aside), aside);
    light->fov_y = glm_rad(random_range(random, 44, 54));
    light->near_plane = random_range(random, 3, 4);
    light->far_plane = random_range(random, 14, 22);
    light->extent = extent;
    return light;
}

static void begin(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, 6, random);
}

// Thin plates beside each other, each higher than the last: their penumbrae go from sharp to wide.
static void add_plates(Scene *scene, Random *random) {
    float turn = random_range(random, -40, 40);
    mat4s turned = glms_rotate_make(glm_rad(turn), vec3_make(0, 1, 0));
    float side = random_int(random, 0, 1) ? 1 : -1;
    for (int i = 0; i < PLATES; i++) {
        float height = 0.15f + 0.65f * (float)i + random_range(random, 0, 0.3f);
        vec3s center = vec3_make(side * (1.05f * (float)i - 1.6f), height, random_range(random, -0.4f, 0.4f));
        part_object(scene, SHAPE_BOX, glms_mat4_mulv3(turned, center, 1),
                    vec3_make(random_range(random, 0.28f, 0.36f), 0.05f, random_range(random, 0.6f, 0.9f)),
                    turn, part_color(random));
    }
}

static void make_plates(Scene *scene, Random *random) {
    begin(scene, random);
    add_plates(scene, random);
    add_lamp(scene, random, GIVEN_EXTENT);
}

static void make_lamps(Scene *scene, Random *random) {
    begin(scene, random);
    add_plates(scene, random);
    add_lamp(scene, random,
             random_int(random, 0, 1) ? random_range(random, 0.2f, 0.4f) : random_range(random, 1, 1.3f));
}

// Posts on the floor: sharp at the foot, soft at the head.
static void make_posts(Scene *scene, Random *random) {
    begin(scene, random);
    for (int i = 0; i < 5; i++) {
        float half_height = random_range(random, 0.25f, 1);
        part_object(
            scene, SHAPE_BOX,
            vec3_make(0.9f * (float)i - 1.8f, half_height, random_range(random, -0.8f, 0.8f)),
            vec3_make(random_range(random, 0.1f, 0.2f), half_height, random_range(random, 0.1f, 0.2f)),
            random_range(random, 0, 90), part_color(random));
    }
    add_lamp(scene, random, GIVEN_EXTENT);
}

static void swap(Object *a, Object *b) {
    Object object = *a;
    *a = *b;
    *b = object;
}

// The object nearest to the lamp comes to the front of the list, and the floor from there to the end.
static void put_nearest_first(Scene *scene) {
    Object *objects = scene->objects, *last = &objects[scene->object_count - 1];
    vec3s lamp = scene->lights[0].position;
    swap(&objects[0], last);
    for (Object *object = objects; object < last; object++)
        if (glms_vec3_distance(glms_vec3(object->world_from_object.col[3]), lamp) <
            glms_vec3_distance(glms_vec3(objects[0].world_from_object.col[3]), lamp))
            swap(&objects[0], object);
}

// Low, small things in a row: far from the near plane, so that a search from there steps over them. The one
// in the middle is clearly nearest to the lamp, a sphere or a box.
static void make_low(Scene *scene, Random *random) {
    begin(scene, random);
    const int sphere = random_int(random, MIDDLE, LOW - 1);
    for (int i = 0; i < LOW; i++) {
        float r = random_range(random, 0.12f, 0.22f);
        part_object(scene, i == sphere ? SHAPE_SPHERE : SHAPE_BOX,
                    vec3_make(1.1f * (float)(i - MIDDLE) + random_range(random, -0.2f, 0.2f),
                              r + random_range(random, 0.3f, 0.6f) + (i == MIDDLE ? 0.9f : 0),
                              random_range(random, -0.8f, 0.8f)),
                    vec3_make(r, r * random_range(random, 0.5f, 1), r), random_range(random, 0, 90),
                    part_color(random));
    }
    add_lamp(scene, random, GIVEN_EXTENT);
    put_nearest_first(scene);
}

const SceneMaker LAB_TABLE[] = {
    {"soft plates", make_plates},
    {"soft lamps", make_lamps},
    {"soft posts", make_posts},
    {"soft low", make_low},
    {0},
};
