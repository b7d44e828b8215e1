// Scenes. Each holds only what shows its phenomenon; what varies is drawn from a seed, so that a picture of one
// variant is worth nothing in another.
#include "scene.h"

#include "check.h"

#include <string.h>

static vec3s random_color(Random *random) {
    return vec3_make(random_range(random, 0.35f, 0.95f), random_range(random, 0.35f, 0.95f),
                     random_range(random, 0.35f, 0.95f));
}

// A point at `distance` from `target`: azimuth about +y from +z, elevation above the horizon, in degrees.
static vec3s orbit(vec3s target, float azimuth, float elevation, float distance) {
    float a = glm_rad(azimuth), e = glm_rad(elevation);
    vec3s direction = vec3_make(cosf(e) * sinf(a), sinf(e), cosf(e) * cosf(a));
    return glms_vec3_add(target, glms_vec3_scale(direction, distance));
}

static Object *add_object(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn, vec3s color) {
    INVARIANT(scene->object_count < SCENE_MAX_OBJECTS);
    mat4s placed = glms_rotate(glms_translate_make(center), glm_rad(turn), vec3_make(0, 1, 0));
    Object *object = &scene->objects[scene->object_count++];
    *object = (Object){.shape = shape,
                       .world_from_object = glms_scale(placed, half_size),
                       .color = color,
                       .specular = 0.3f,
                       .shininess = 32};
    return object;
}

static void add_floor(Scene *scene, float half_size, Random *random) {
    Object *floor = add_object(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(half_size, 1, half_size), 0,
                               random_color(random));
    floor->specular = 0;
}

static void add_light(Scene *scene, LightKind kind, vec3s position, vec3s target) {
    INVARIANT(scene->light_count < SCENE_MAX_LIGHTS);
    scene->lights[scene->light_count++] = (Light){.kind = kind,
                                                  .position = position,
                                                  .target = target,
                                                  .color = vec3_make(0.8f, 0.8f, 0.75f),
                                                  .fov_y = glm_rad(50),
                                                  .half_size = 4.5f,
                                                  .near_plane = 4, // near and far close around the scene: more of the map's range is used
                                                  .far_plane = 16};
}

// Camera and colours that every scene shares.
static void begin(Scene *scene, Random *random) {
    float azimuth = random_range(random, -35, 35), elevation = random_range(random, 28, 45);
    vec3s target = vec3_make(0, 0.4f, 0);
    float dim = random_range(random, 0.15f, 0.3f);
    *scene = (Scene){.camera = {.eye = orbit(target, azimuth, elevation, random_range(random, 8, 9.5f)),
                                .target = target,
                                .fov_y = glm_rad(40),
                                .near_plane = 0.5f,
                                .far_plane = 60},
                     .ambient = vec3_make(dim, dim, dim * 1.1f),
                     .background = vec3_make(random_range(random, 0.05f, 0.2f), random_range(random, 0.1f, 0.2f),
                                             random_range(random, 0.2f, 0.35f))};
    scene->second_camera = scene->camera;
}

// A box on the floor and a sphere above it, a little apart.
static void add_casters(Scene *scene, Random *random) {
    float h = random_range(random, 0.5f, 0.8f), r = random_range(random, 0.45f, 0.65f);
    add_object(scene, SHAPE_BOX, vec3_make(random_range(random, -1.6f, -0.9f), h, random_range(random, -0.6f, 0.6f)),
               vec3_make(random_range(random, 0.4f, 0.6f), h, random_range(random, 0.4f, 0.6f)),
               random_range(random, 10, 80), random_color(random));
    add_object(scene, SHAPE_SPHERE,
               vec3_make(random_range(random, 0.7f, 1.4f), r + random_range(random, 0.2f, 0.6f),
                         random_range(random, -0.6f, 0.6f)),
               vec3_make(r, r, r), 0, random_color(random));
}

static vec3s light_above(Random *random, float elevation_low, float elevation_high, float distance) {
    float side = random_int(random, 0, 1) ? 1 : -1;
    float azimuth = side * random_range(random, 100, 160);
    return orbit(vec3_make(0, 0, 0), azimuth, random_range(random, elevation_low, elevation_high), distance);
}

static void make_studio(Scene *scene, Random *random) {
    begin(scene, random);
    add_floor(scene, 6, random);
    add_casters(scene, random);
    add_light(scene, LIGHT_DIRECTIONAL, light_above(random, 45, 65, 10), vec3_make(0, 0, 0));
    scene->camera.target.y = 0.9f;
    Object *screen = add_object(scene, SHAPE_PLANE, vec3_make(0, 1.6f, -2), vec3_make(2, 1, 1.2f), 0,
                                random_color(random));
    screen->is_screen = 1;
    screen->world_from_object = glms_rotate(glms_translate_make(vec3_make(random_range(random, -0.4f, 0.4f), 1.7f, -2)),
                                            glm_rad(random_range(random, 70, 88)), vec3_make(1, 0, 0));
    screen->world_from_object = glms_scale(screen->world_from_object, vec3_make(1.9f, 1, 1.3f));
    vec3s middle = vec3_make(0, 0.5f, 0);
    scene->second_camera.eye = orbit(middle, random_range(random, 120, 240), random_range(random, 15, 40), 6);
    scene->second_camera.target = middle;
    scene->second_camera.near_plane = random_range(random, 2.5f, 3);
    scene->second_camera.far_plane = random_range(random, 12, 14);
}

static void make_table_spot(Scene *scene, Random *random) {
    begin(scene, random);
    add_floor(scene, 6, random);
    add_casters(scene, random);
    add_light(scene, LIGHT_SPOT, light_above(random, 45, 70, random_range(random, 9, 10)), vec3_make(0, 0, 0));
}

static void make_table_sun(Scene *scene, Random *random) {
    begin(scene, random);
    add_floor(scene, 6, random);
    add_casters(scene, random);
    add_light(scene, LIGHT_DIRECTIONAL, light_above(random, 40, 70, random_range(random, 9, 10)), vec3_make(0, 0, 0));
}

// The map covers only the middle of the floor, with a caster that its edge cuts.
static void make_wide_floor(Scene *scene, Random *random) {
    begin(scene, random);
    add_floor(scene, 12, random);
    add_casters(scene, random);
    bool spot = random_int(random, 0, 1) == 1;
    add_light(scene, spot ? LIGHT_SPOT : LIGHT_DIRECTIONAL, light_above(random, 50, 65, 10), vec3_make(0, 0, 0));
    scene->lights[0].fov_y = glm_rad(random_range(random, 14, 16));
    scene->lights[0].half_size = random_range(random, 1.1f, 1.3f);
}

// The floor passes through the far plane of the light: what lies behind it has a depth above 1.
static void make_far_floor(Scene *scene, Random *random) {
    begin(scene, random);
    add_floor(scene, 4, random);
    add_casters(scene, random);
    bool spot = random_int(random, 0, 1) == 1;
    add_light(scene, spot ? LIGHT_SPOT : LIGHT_DIRECTIONAL, light_above(random, 35, 45, 10), vec3_make(0, 0, 0));
    scene->lights[0].far_plane = random_range(random, 10.2f, 10.8f);
    scene->lights[0].half_size = 6;
}

// The lamp hangs low over the floor and looks to the side: half of the floor lies behind it.
static void make_behind(Scene *scene, Random *random) {
    begin(scene, random);
    add_floor(scene, 4, random);
    float side = random_int(random, 0, 1) ? 1 : -1;
    float height = random_range(random, 0.9f, 1.2f);
    vec3s lamp = vec3_make(side * random_range(random, 0, 0.4f), height, random_range(random, -0.3f, 0.3f));
    add_object(scene, SHAPE_BOX, vec3_make(lamp.x + side * 2, 1.2f, lamp.z), vec3_make(0.2f, 1.2f, 0.9f),
               side * random_range(random, 5, 25), random_color(random));
    add_light(scene, LIGHT_SPOT, lamp, vec3_make(lamp.x + side * 2, height - 0.1f, lamp.z));
    scene->lights[0].fov_y = glm_rad(90);
    scene->lights[0].near_plane = 0.2f;
    scene->lights[0].far_plane = 12;
}

static const struct {
    const char *name;
    void (*make)(Scene *scene, Random *random);
} scenes[] = {
    {"studio", make_studio},         {"table spot", make_table_spot}, {"table sun", make_table_sun},
    {"wide floor", make_wide_floor}, {"far floor", make_far_floor},   {"behind", make_behind},
};

enum { SCENE_COUNT = sizeof scenes / sizeof scenes[0] };

const char *scene_name(int i) {
    return i >= 0 && i < SCENE_COUNT ? scenes[i].name : NULL;
}

bool scene_make(Scene *scene, const char *name, Random *random) {
    for (int i = 0; i < SCENE_COUNT; i++)
        if (strcmp(scenes[i].name, name) == 0) {
            scenes[i].make(scene, random);
            return true;
        }
    char names[512] = "";
    for (int i = 0; i < SCENE_COUNT; i++)
        check_append(names, sizeof names, "%s\"%s\"", i ? ", " : "", scenes[i].name);
    return check_fail("there is no scene \"%s\"; the scenes are %s", name, names);
}
