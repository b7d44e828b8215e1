// Dust in the study: more and more steps, on larger and larger maps, beside the faces.
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <string.h>

// A post before a low sun, and a slab that keeps the sun from the eye.
static void make_dust(Scene *scene) {
    const vec3s eye = vec3_make(0.2f, 1.4f, 6.5f);
    *scene = (Scene){0};
    study_look(scene, eye, vec3_make(0, 1.3f, 0));
    scene->camera.far_plane = 16;
    scene->medium = (Medium){.scattering = 0.1f, .extinction = 0.11f};
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(16, 1, 16), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(0, 1.5f, -1), vec3_make(0.3f, 1.5f, 0.3f), 20);
    closed_add(scene, SHAPE_BOX, vec3_make(0.35f, 2.75f, 4.5f), vec3_make(0.5f, 0.1f, 0.5f), 30);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(1.2f, 5.5f, -8), vec3_make(0, 0, 0), 0, 8, 0.5f, 24);
}

static const StudyScene scenes[] = {
    {"dust",
     "Dust in the light: steps against faces",
     "shadows that hang in the air; the eye stands in one",
     make_dust,
     {.kind = TRUTH_DUST},
     false,
     STUDY_SOFT,
     .moves = false},
    {0},
};

static void add_march(MethodList *list, int steps, int jitter, int map_size) {
    Method *method =
        method_add_map(list, LAB_ID, jitter ? "march with jitter" : "march", map_size, "%d steps", steps);
    setting_knob(&method->setting, "dust", 1);
    setting_knob(&method->setting, "steps", (float)steps);
    setting_knob(&method->setting, "jitter", (float)jitter);
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "dust") != 0)
        return;
    for (int steps = 4; steps <= 64; steps *= 2)
        for (int jitter = 0; jitter < 2; jitter++)
            add_march(list, steps, jitter, 1024);
    add_march(list, 64, 0, 256);
    add_march(list, 64, 0, 2048);
    Method *faces = method_add(list, LAB_ID, "faces of the volumes", "merged intervals");
    setting_knob(&faces->setting, "dust", 2);
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods}};
