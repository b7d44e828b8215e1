// Random samples in the study, and the scene of a wide penumbra.
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <string.h>

// The lamp of the scene "penumbra": a disc parallel to the wall. Seen from the wall through the plates'
// plane, at height h of H, it has the radius r h / H there; the map, of half width (H - h) tan(fov / 2)
// there, sees that as 2 / STUDY_KERNEL of its half width.
enum { LAMP_HEIGHT = 10, PLATE_HEIGHT = 2 };
static const float lamp_fov = 0.62f;
#define LAMP_TANGENT 0.3203275F // tan(lamp_fov / 2)
#define LAMP_RADIUS                                                                                          \
    (2 * (LAMP_HEIGHT - PLATE_HEIGHT) * LAMP_TANGENT / STUDY_KERNEL * LAMP_HEIGHT / PLATE_HEIGHT)

// A plate and two bars narrower than the kernel at one height before a wall, so that one kernel fits.
static void make_penumbra(Scene *scene) {
    const float h = PLATE_HEIGHT;
    *scene = closed_wall(3.2f, 10, glm_rad(36));
    study_look(scene, vec3_make(2.9f, 0.4f, 2.5f), vec3_make(-0.15f, 0, 0));
    study_add_turned(scene, SHAPE_BOX, vec3_make(-0.7f, 0.5f, h), vec3_make(0.45f, 0.25f, 0.01f), 20);
    study_add_turned(scene, SHAPE_BOX, vec3_make(-0.6f, -0.6f, h), vec3_make(0.5f, 0.035f, 0.01f), -10);
    study_add_turned(scene, SHAPE_BOX, vec3_make(0.5f, 0.1f, h), vec3_make(0.035f, 0.6f, 0.01f), 30);
    closed_light(scene, LIGHT_SPOT, vec3_make(0, 0, LAMP_HEIGHT), vec3_make(0, 0, 0), lamp_fov, 0, 4, 16);
}

static const StudyScene scenes[] = {
    {"penumbra",
     "A disc of light: wide penumbrae",
     "one width of penumbra, and casters narrower than it",
     make_penumbra,
     {.kind = TRUTH_DISC,
      .area = {{{0, 0, LAMP_HEIGHT}}, {{LAMP_RADIUS, 0, 0}}, {{0, LAMP_RADIUS, 0}}},
      .samples = 1024,
      .seed = 1},
     true,
     STUDY_SOFT,
     .moves = false},
    {0},
};

// Where penumbrae have several widths, no radius is the matched one: a narrow, a middle and a wide one.
static void add_to_wide_lamp(MethodList *list) {
    for (int radius = 3; radius <= 12; radius *= 2) {
        Method *method =
            method_add_map(list, LAB_ID, "random with early-out", 512, "32 samples, radius %d", radius);
        setting_knob(&method->setting, "radius", (float)radius);
        method->kernel = (float)radius;
    }
}

// Random samples in a disc of `radius` texels; `wide` says by how much that is not the matched one.
static void add_random(MethodList *list, int size, int columns, int rows, bool early_out, float wide) {
    int samples = columns * rows;
    Method *method =
        method_add_map(list, LAB_ID, early_out ? "random with early-out" : "random", size,
                       wide == 1 ? "%d samples" : "%d samples, radius x %g", samples, (double)wide);
    setting_knob(&method->setting, "columns", (float)columns);
    setting_knob(&method->setting, "rows", (float)rows);
    setting_knob(&method->setting, "radius", wide * (float)size / STUDY_KERNEL);
    setting_knob(&method->setting, "early-out", early_out);
    method->kernel = wide * (float)size / STUDY_KERNEL;
}

static void add_methods(MethodList *list, const char *scene) {
    const int grids[][2] = {{4, 2}, {4, 4}, {4, 8}, {8, 8}, {16, 16}};
    if (strcmp(scene, "wide lamp") == 0)
        add_to_wide_lamp(list);
    if (strcmp(scene, "penumbra") != 0)
        return;
    for (int size = 256; size <= 1024; size *= 4)
        for (int grid = 0; grid < 5; grid++)
            for (int early_out = 0; early_out < (grid > 0 ? 2 : 1); early_out++)
                add_random(list, size, grids[grid][0], grids[grid][1], early_out, 1);
    add_random(list, 512, 4, 8, true, 1);
    add_random(list, 2048, 4, 8, true, 1);
    add_random(list, 4096, 4, 8, true, 1);
    add_random(list, 1024, 4, 8, true, 0.5f);
    add_random(list, 1024, 4, 8, true, 2);
}

// The lamp stays where its area is; instead the plates move the other way.
static void settle(Scene *scene, const char *name) {
    Light *light = &scene->lights[0];
    if (strcmp(name, "penumbra") != 0)
        return;
    for (int i = 1; i < scene->object_count; i++)
        for (int c = 0; c < 2; c++)
            scene->objects[i].world_from_object.raw[3][c] -= light->target.raw[c];
    light->target = vec3_make(0, 0, 0);
    light->position = vec3_make(0, 0, LAMP_HEIGHT);
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods, .settle = settle}};
