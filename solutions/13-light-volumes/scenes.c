// Scenes of dust in the light: what is seen lies before a floor and a far plane that is near, since the dust
// ends there.
#include "scene/scene_parts.h"

enum { UNDER_THE_LAMP = 5 };

static vec3s warm(void) {
    return vec3_make(1, 0.95f, 0.85f);
}

// Dust that loses about as much as it scatters.
static void fill_air(Scene *scene, Random *random) {
    scene->medium.scattering = random_range(random, 0.09f, 0.12f);
    scene->medium.extinction = scene->medium.scattering * random_range(random, 1, 1.25f);
}

static void begin(Scene *scene, Random *random) {
    part_begin(scene, random);
    scene->ambient = glms_vec3_scale(scene->ambient, 0.5f);
    scene->background = glms_vec3_scale(scene->background, 0.3f);
    scene->camera.far_plane = random_range(random, 15, 19);
    fill_air(scene, random);
    part_floor(scene, 15, random);
}

// A spot light or a sun, far enough for all to be before it; at times straight above.
static Light *light_from(Scene *scene, Random *random, float lowest, float highest) {
    bool overhead = random_int(random, 0, UNDER_THE_LAMP) == 0;
    vec3s place = part_above(random, lowest, highest, random_range(random, 9, 11));
    if (overhead)
        place = vec3_make(0, place.y, 0);
    Light *light;
    if (random_int(random, 0, 1)) {
        light = part_light(scene, LIGHT_SPOT, place, vec3_make(0, 0.3f, 0));
    } else {
        vec3s aside = vec3_make(random_range(random, -1, 1), 0, random_range(random, -1, 1));
        light = part_light(scene, LIGHT_DIRECTIONAL, glms_vec3_add(place, aside), aside);
    }
    light->color = warm();
    return light;
}

// Nothing throws a shadow into the air: a floor, and a wall that the light is before.
static void make_bare(Scene *scene, Random *random) {
    begin(scene, random);
    float x = (random_int(random, 0, 1) ? 1.f : -1.f) * random_range(random, 1, 2.5f);
    Object *wall =
        part_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(1.3f, 1, 2), 0, part_color(random));
    mat4s placed = glms_rotate(glms_translate_make(vec3_make(x, 1.6f, random_range(random, -4, -1))),
                               random_range(random, -0.5f, 0.5f), vec3_make(0, 1, 0));
    placed = glms_rotate(placed, GLM_PI_2f, vec3_make(1, 0, 0));
    wall->world_from_object = glms_mat4_mul(placed, wall->world_from_object);
    vec3s place =
        part_orbit(vec3_make(0, 0, 0), random_range(random, -40, 40), random_range(random, 60, 85), 12);
    part_light(scene, random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_DIRECTIONAL, place, vec3_make(0, 0, 0))
        ->color = warm();
}

static void make_thin(Scene *scene, Random *random) {
    make_bare(scene, random);
    scene->medium = (Medium){.scattering = random_range(random, 0.03f, 0.05f)};
}

// In floats 1 - e^(-a d) is not a number to divide by a any more.
static void make_faint(Scene *scene, Random *random) {
    make_thin(scene, random);
    scene->medium.extinction = random_range(random, 3e-8f, 6e-8f);
}

// So little that one may think the way itself were the sum: over the longest ways it is not.
static void make_weak(Scene *scene, Random *random) {
    make_bare(scene, random);
    scene->medium = (Medium){.scattering = 0.05f, .extinction = random_range(random, 0.004f, 0.005f)};
}

// Boxes and spheres that float in a row from left to right, as the camera sees it.
static void float_casters(Scene *scene, Random *random, int count, float lowest, float highest) {
    for (int i = 0; i < count; i++) {
        float r = random_range(random, 0.35f, 0.55f), x = 3.6f * ((float)i + 0.5f) / (float)count - 1.8f;
        part_object(scene, (i + random_int(random, 0, 1)) % 2 ? SHAPE_BOX : SHAPE_SPHERE,
                    vec3_make(x, random_range(random, lowest, highest), random_range(random, -0.7f, 0.7f)),
                    vec3_make(r, r * random_range(random, 0.6f, 1), r), random_range(random, 0, 90),
                    part_color(random));
    }
}

static void make_casters(Scene *scene, Random *random) {
    begin(scene, random);
    float_casters(scene, random, 4, 1.2f, 2.4f);
    light_from(scene, random, 30, 65);
}

// Where the map says nothing: half of the picture lies behind a spot light.
static void make_beyond_spot(Scene *scene, Random *random) {
    begin(scene, random);
    float_casters(scene, random, 3, 0.5f, 1.2f);
    vec3s place = vec3_make(random_range(random, -1.5f, 1.5f), random_range(random, 1.5f, 2.2f),
                            random_range(random, -1, 0));
    float side = place.x < 0 ? 1 : -1;
    Light *light = part_light(scene, LIGHT_SPOT, place,
                              glms_vec3_add(place, vec3_make(3 * side, random_range(random, -2, -1), 0)));
    light->near_plane = 0.3f;
    light->color = warm();
}

// ... or beyond the sides and the far plane of a small map.
static void make_beyond_sun(Scene *scene, Random *random) {
    begin(scene, random);
    float_casters(scene, random, 3, 1, 1.8f);
    vec3s place = part_above(random, 40, 60, 10);
    Light *light = part_light(scene, LIGHT_DIRECTIONAL, place, vec3_make(0, 0, 0));
    light->half_size = random_range(random, 1.6f, 2.2f);
    light->far_plane = random_range(random, 9, 10);
    light->color = warm();
}

// One caster beside the eye's way.
static void make_one(Scene *scene, Random *random) {
    begin(scene, random);
    float r = random_range(random, 0.5f, 0.9f);
    part_object(scene, random_int(random, 0, 1) ? SHAPE_BOX : SHAPE_SPHERE,
                vec3_make(random_range(random, -0.6f, 0.6f), random_range(random, 1.2f, 2), 0),
                vec3_make(r, r, r), random_range(random, 0, 90), part_color(random));
    light_from(scene, random, 35, 65);
}

// The light comes from behind the eye, and one caster stands `aside` of the line between them, in units of
// its own size: at 0 the eye is in its shadow.
static void behind_the_eye(Scene *scene, Random *random, float aside) {
    begin(scene, random);
    vec3s eye = scene->camera.eye;
    float azimuth = glm_deg(atan2f(eye.x, eye.z)) + random_range(random, -25, 25);
    vec3s lamp = part_orbit(vec3_make(0, 0, 0), azimuth, random_range(random, 35, 55), 16);
    bool sun = random_int(random, 0, 1);
    vec3s toward = glms_vec3_normalize(sun ? lamp : glms_vec3_sub(lamp, eye));
    vec3s across = glms_vec3_normalize(glms_vec3_cross(toward, vec3_make(0, 1, 0)));
    float r = random_range(random, 0.7f, 1.1f);
    vec3s center = glms_vec3_add(eye, glms_vec3_scale(toward, random_range(random, 2, 2.5f)));
    center = glms_vec3_add(center, glms_vec3_scale(across, aside * r));
    part_object(scene, random_int(random, 0, 1) ? SHAPE_BOX : SHAPE_SPHERE, center, vec3_make(r, r, r),
                random_range(random, 0, 90), part_color(random));
    part_light(scene, sun ? LIGHT_DIRECTIONAL : LIGHT_SPOT, lamp, vec3_make(0, 0, 0))->color = warm();
}

static void make_inside(Scene *scene, Random *random) {
    behind_the_eye(scene, random, random_range(random, -0.4f, 0.4f));
}

// A ray enters the shadow before the near plane, and leaves it behind the far plane.
static void make_cut(Scene *scene, Random *random) {
    float side = random_int(random, 0, 1) ? 1 : -1;
    behind_the_eye(scene, random, side * random_range(random, 1.2f, 1.7f));
    scene->camera.near_plane = random_range(random, 2, 4);
    scene->camera.far_plane = random_range(random, 9, 11);
}

// Two or three casters side by side, the light before or behind them: their shadows do not meet.
static void make_apart(Scene *scene, Random *random) {
    begin(scene, random);
    int count = random_int(random, 2, 3);
    for (int i = 0; i < count; i++) {
        float r = random_range(random, 0.3f, 0.5f), x = 4 * ((float)i + 0.5f) / (float)count - 2;
        part_object(scene, i % 2 ? SHAPE_BOX : SHAPE_SPHERE,
                    vec3_make(x, random_range(random, 1, 2.2f), random_range(random, -0.7f, 0.7f)),
                    vec3_make(r, r, r), random_range(random, 0, 90), part_color(random));
    }
    vec3s place = part_orbit(vec3_make(0, 0, 0),
                             random_range(random, -10, 10) + (float)(180 * random_int(random, 0, 1)),
                             random_range(random, 45, 70), 12);
    part_light(scene, random_int(random, 0, 1) ? LIGHT_SPOT : LIGHT_DIRECTIONAL, place, vec3_make(0, 0, 0))
        ->color = warm();
}

// Two pairs of casters, each pair in a line with the light, one pair behind the other for the camera: shadows
// lie in each other, and a ray may cross two that do not meet.
static void make_overlap(Scene *scene, Random *random) {
    begin(scene, random);
    Light *light = light_from(scene, random, 40, 65);
    vec3s aim = light->kind == LIGHT_DIRECTIONAL ? light->target : vec3_make(0, 0.3f, 0);
    vec3s toward = glms_vec3_normalize(glms_vec3_sub(light->position, aim));
    for (int i = 0; i < 4; i++) {
        int pair = i / 2;
        float r = random_range(random, 0.4f, 0.6f), back = (float)pair;
        vec3s center = glms_vec3_add(aim, glms_vec3_scale(toward, 1 + (float)(i % 2) + 0.8f * back));
        center.x += random_range(random, -0.4f, 0.4f);
        center.z += random_range(random, 0.8f, 1.2f) - 2.4f * back;
        part_object(scene, i % 2 ? SHAPE_SPHERE : SHAPE_BOX, center, vec3_make(r, 0.3f, r),
                    random_range(random, 0, 90), part_color(random));
    }
}

// A spot light in the picture that shines to the left or right: two casters in a line with it, a larger one
// in its plane, so that this shadow lies partly behind the light.
static void shine_across(Scene *scene, Random *random, float side) {
    vec3s lamp = vec3_make(-side * random_range(random, 0.3f, 0.8f), random_range(random, 1.7f, 2.1f), 0);
    vec3s aim = glms_vec3_add(lamp, vec3_make(3 * side, random_range(random, -0.8f, 0), 0));
    for (int i = 0; i < 3; i++) {
        float r = random_range(random, 0.3f, 0.45f) + (i == 2 ? 0.2f : 0);
        vec3s center = lamp;
        center.x += side * (i < 2 ? 1 + (float)i : 0);
        center.y += i == 2 ? random_range(random, -0.9f, -0.7f) : random_range(random, -0.2f, 0.1f);
        center.z += i == 2 ? random_range(random, 0.5f, 0.8f) : random_range(random, -0.2f, 0.2f);
        part_object(scene, i % 2 ? SHAPE_SPHERE : SHAPE_BOX, center, vec3_make(r, r, r),
                    random_range(random, 0, 90), part_color(random));
    }
    Light *light = part_light(scene, LIGHT_SPOT, lamp, aim);
    light->near_plane = 0.3f;
    light->color = warm();
}

static void make_before(Scene *scene, Random *random) {
    begin(scene, random);
    shine_across(scene, random, scene->camera.eye.x > 0 ? 1 : -1);
}

static void make_behind(Scene *scene, Random *random) {
    begin(scene, random);
    shine_across(scene, random, scene->camera.eye.x > 0 ? -1 : 1);
}

// A gate of posts with the sun low behind it.
static void make_gate(Scene *scene, Random *random) {
    begin(scene, random);
    scene->camera.eye = vec3_make(random_range(random, -1, 1), random_range(random, 0.8f, 1.4f), 7);
    scene->camera.target = vec3_make(0, 1.3f, 0);
    scene->objects[0].color = vec3_make(0.25f, 0.24f, 0.22f);
    for (int i = 0; i < 7; i++) {
        float x = 1.1f * (float)i - 3.3f + random_range(random, -0.15f, 0.15f);
        part_object(scene, SHAPE_BOX, vec3_make(x, random_range(random, 1, 1.6f), -1),
                    vec3_make(random_range(random, 0.2f, 0.35f), 1.6f, 0.25f), 0,
                    vec3_make(0.3f, 0.28f, 0.25f));
    }
    Light *light = part_light(scene, LIGHT_DIRECTIONAL,
                              vec3_make(random_range(random, -3, 3), random_range(random, 4, 5), -8),
                              vec3_make(0, 0, 0));
    light->color = vec3_make(3.2f, 2.7f, 2);
}

const SceneMaker LAB_TABLE[] = {
    {"dust bare", make_bare},       {"dust thin", make_thin},
    {"dust casters", make_casters}, {"dust beyond spot", make_beyond_spot},
    {"dust one", make_one},         {"dust beyond sun", make_beyond_sun},
    {"dust cut", make_cut},         {"dust inside", make_inside},
    {"dust apart", make_apart},     {"dust overlap", make_overlap},
    {"dust gate", make_gate},       {"dust faint", make_faint},
    {"dust weak", make_weak},       {"dust before", make_before},
    {"dust behind", make_behind},   {0},
};
