// Scenes of light maps: planes and boxes that stand still and have luxels, balls that move and have none.
#include "scene/scene_parts.h"

enum { SELDOM = 5 };

// Gives a lamp the intensity that makes its light at the distance r about `bright`; a sun has it everywhere.
static void brighten(Light *light, float r, float bright) {
    float intensity = light->kind == LIGHT_DIRECTIONAL ? bright : bright * r * r;
    light->color = vec3_make(intensity, intensity * 0.95f, intensity * 0.85f);
}

// A lamp or a sun above the casters, seldom straight above. `front`: on the camera's side.
static Light *light_above(Scene *scene, Random *random, LightKind kind, bool front, float distance) {
    vec3s place = part_above(random, 40, 65, distance);
    bool overhead = random_int(random, 0, SELDOM) == 0;
    place.z = front ? fabsf(place.z) : place.z;
    if (overhead)
        place = vec3_make(0, distance, 0);
    vec3s target = vec3_make(random_range(random, -0.6f, 0.6f), 0, random_range(random, -0.4f, 0.4f));
    if (overhead)
        target = vec3_make(place.x, 0, place.z);
    Light *light = part_light(scene, kind, place, target);
    brighten(light, distance, random_range(random, 0.7f, 0.9f));
    return light;
}

static LightKind any_kind(Random *random) {
    return (LightKind)random_int(random, LIGHT_SPOT, LIGHT_POINT);
}

static void tilt(Object *object, float about_x, float about_z) {
    mat4s turned = glms_rotate_make(glm_rad(about_x), vec3_make(1, 0, 0));
    turned = glms_rotate(turned, glm_rad(about_z), vec3_make(0, 0, 1));
    vec3s center = glms_vec3(object->world_from_object.col[3]);
    object->world_from_object.col[3] = (vec4s){{0, 0, 0, 1}};
    object->world_from_object = glms_mat4_mul(turned, object->world_from_object);
    object->world_from_object.col[3] = glms_vec4(center, 1);
}

static Object *add_box(Scene *scene, Random *random, vec3s center, float half) {
    return part_object(
        scene, SHAPE_BOX, center,
        vec3_make(half, half * random_range(random, 0.5f, 1.2f), half * random_range(random, 0.7f, 1.2f)),
        random_range(random, 0, 90), part_color(random));
}

// Boxes in a row from left to right, their middles between two heights.
static void add_boxes(Scene *scene, Random *random, int count, float lowest, float highest) {
    for (int i = 0; i < count; i++) {
        float x = 2.8f * ((float)i + 0.5f) / (float)count - 1.4f + random_range(random, -0.2f, 0.2f);
        add_box(scene, random,
                vec3_make(x, random_range(random, lowest, highest), random_range(random, -0.8f, 0.8f)),
                random_range(random, 0.3f, 0.5f));
    }
}

static void add_ball(Scene *scene, Random *random, float x) {
    float r = random_range(random, 0.3f, 0.45f);
    vec3s center = vec3_make(x + random_range(random, -0.3f, 0.3f), random_range(random, 0.6f, 1.3f),
                             random_range(random, 0.1f, 1));
    part_object(scene, SHAPE_SPHERE, center, vec3_make(r, r, r), 0, part_color(random));
}

// Floor and tilted boxes, the light on the camera's side: all that one sees is lit.
static void make_blocks(Scene *scene, Random *random) {
    part_begin(scene, random);
    tilt(part_floor(scene, random_range(random, 1.8f, 2.2f), random), random_range(random, -8, 8),
         random_range(random, -8, 8));
    add_boxes(scene, random, 3, 0.4f, 0.9f);
    tilt(&scene->objects[2], random_range(random, -30, 30), random_range(random, -30, 30));
    light_above(scene, random, any_kind(random), true, random_range(random, 6, 9));
}

// Faces that look to all sides.
static void add_faces(Scene *scene, Random *random, bool front) {
    part_begin(scene, random);
    tilt(part_floor(scene, random_range(random, 1.8f, 2.6f), random), random_range(random, -15, 15),
         random_range(random, -15, 15));
    add_boxes(scene, random, 2, 0.4f, 0.9f);
    tilt(&scene->objects[1], random_range(random, -40, 40), random_range(random, -40, 40));
    light_above(scene, random, any_kind(random), front, random_range(random, 2.5f, 4));
}

static void make_faces(Scene *scene, Random *random) {
    add_faces(scene, random, random_int(random, 0, 1));
}

// The light behind them: what one sees of the boxes looks away from it.
static void make_backlit(Scene *scene, Random *random) {
    add_faces(scene, random, false);
}

// Things between the light and the floor, under the floor, and beyond the place of the light: there they are
// in the way of a sun only.
static void add_casters(Scene *scene, Random *random, LightKind kind) {
    part_begin(scene, random);
    tilt(part_floor(scene, random_range(random, 1.8f, 2.2f), random), random_range(random, -8, 8),
         random_range(random, -8, 8));
    add_boxes(scene, random, 2, 0.3f, 0.9f);
    Light *light = light_above(scene, random, kind, random_int(random, 0, 1), random_range(random, 4, 5));
    vec3s beyond = glms_vec3_lerp(light->target, light->position, random_range(random, 1.25f, 1.4f));
    add_box(scene, random, beyond, kind == LIGHT_DIRECTIONAL ? 0.4f : 0.9f);
    add_box(scene, random, vec3_make(random_range(random, -0.6f, 0.6f), -1.2f, 0), 0.5f);
}

static void make_spot(Scene *scene, Random *random) {
    add_casters(scene, random, LIGHT_SPOT);
}

static void make_sun(Scene *scene, Random *random) {
    add_casters(scene, random, LIGHT_DIRECTIONAL);
}

static void make_point(Scene *scene, Random *random) {
    add_casters(scene, random, LIGHT_POINT);
}

static void make_wide(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, random_range(random, 1.8f, 2.4f), random);
    add_boxes(scene, random, 2, 0.7f, 1.4f);
    LightKind kind = random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_POINT;
    light_above(scene, random, kind, random_int(random, 0, 1), random_range(random, 4, 6))->extent =
        random_range(random, 0.4f, 0.8f);
}

// The map holds less than the floor, on which light also falls beyond it: beside it, and behind its far
// plane. The boxes are low, so that a bias of one's own takes much of their shadows.
static void make_mapped(Scene *scene, Random *random) {
    part_begin(scene, random);
    part_floor(scene, random_range(random, 2.6f, 3.2f), random);
    add_boxes(scene, random, 3, 0.3f, 0.6f);
    LightKind kind = random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_DIRECTIONAL;
    Light *light = light_above(scene, random, kind, random_int(random, 0, 1), random_range(random, 7, 9));
    light->half_size = random_range(random, 1.6f, 2.2f);
    light->fov_y = glm_rad(random_range(random, 24, 32));
    light->far_plane = glms_vec3_distance(light->position, light->target) + random_range(random, 0.4f, 0.8f);
}

// Balls and boxes. A ball comes first, so that the faces' numbers do not begin with a chart.
static void make_balls(Scene *scene, Random *random) {
    part_begin(scene, random);
    add_ball(scene, random, random_int(random, 0, 1) ? -1.1f : -0.6f);
    part_floor(scene, random_range(random, 1.8f, 2.4f), random);
    add_boxes(scene, random, 2, 0.3f, 0.6f);
    add_ball(scene, random, 0.8f);
    LightKind kind = random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_DIRECTIONAL;
    light_above(scene, random, kind, random_int(random, 0, 1), random_range(random, 6, 9));
}

// A lamp so near to a dark floor that more light than 1 arrives.
static void make_near(Scene *scene, Random *random) {
    part_begin(scene, random);
    Object *floor = part_floor(scene, random_range(random, 1.8f, 2.4f), random);
    floor->color = glms_vec3_scale(floor->color, 0.25f);
    Light *light = light_above(scene, random, LIGHT_POINT, true, random_range(random, 1.2f, 2));
    brighten(light, glms_vec3_norm(light->position), random_range(random, 3, 4));
}

// A large floor from afar, at a low angle: a pixel covers many luxels.
static void make_far(Scene *scene, Random *random) {
    part_begin(scene, random);
    vec3s target = vec3_make(0, 0, 0);
    scene->camera.target = target;
    scene->camera.eye = part_orbit(target, random_range(random, -35, 35), random_range(random, 10, 15),
                                   random_range(random, 50, 60));
    scene->camera.far_plane = 100;
    scene->second_camera = scene->camera;
    part_floor(scene, random_range(random, 11, 13), random);
    part_object(scene, SHAPE_BOX, vec3_make(random_range(random, -3, 3), 2, random_range(random, -3, 3)),
                vec3_make(3, 2, 2.5f), random_range(random, 0, 90), part_color(random));
    light_above(scene, random, any_kind(random), true, random_range(random, 9, 12));
}

const SceneMaker LAB_TABLE[] = {
    {"luxel blocks", make_blocks}, {"luxel faces", make_faces},   {"luxel backlit", make_backlit},
    {"luxel spot", make_spot},     {"luxel sun", make_sun},       {"luxel point", make_point},
    {"luxel wide", make_wide},     {"luxel mapped", make_mapped}, {"luxel balls", make_balls},
    {"luxel near", make_near},     {"luxel far", make_far},       {0},
};
