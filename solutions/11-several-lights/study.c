// Several hard lights in the study, and lab 10's wide lamp by more and more maps.
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <string.h>

// A floor, a wall, three casters; a spot light, a sun, and a lamp between the casters.
static void make_lights(Scene *scene) {
    *scene = (Scene){0};
    study_look(scene, vec3_make(0.4f, 3.4f, 6.2f), vec3_make(0, 0.5f, -0.4f));
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(4, 1, 4), 0);
    closed_stand(scene, vec3_make(0, 1.5f, -2.2f), 4, 1.5f, 0);
    closed_add(scene, SHAPE_BOX, vec3_make(-1.6f, 0.45f, 0.3f), vec3_make(0.4f, 0.3f, 0.4f), 30);
    closed_add(scene, SHAPE_SPHERE, vec3_make(0.2f, 0.6f, -0.9f), vec3_make(0.35f, 0.35f, 0.35f), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(1.6f, 0.8f, 0), vec3_make(0.35f, 0.35f, 0.35f), 15);
    closed_light(scene, LIGHT_SPOT, vec3_make(-1.6f, 5, 4), vec3_make(0, 0.4f, -0.4f), glm_rad(80), 0, 1, 14);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(4, 6, 5), vec3_make(0, 0.4f, -0.4f), 0, 5, 1, 20);
    closed_light(scene, LIGHT_POINT, vec3_make(0, 1.3f, 0.5f), vec3_make(0, 0.4f, -0.4f), 0, 0, 0.2f, 14);
}

static const StudyScene scenes[] = {
    {"lights",
     "A spot light, a sun and a lamp: a map, a map and a cube",
     "three hard lights at once, one of them between the casters",
     make_lights,
     {.kind = TRUTH_LIGHTS},
     false, // edges of one light lie where the mean is not 1/2
     1e-3,
     .moves = false},
    {0},
};

static void add_lamps(MethodList *list, int n, int jitter) {
    Method *method = method_add_map(list, LAB_ID, jitter ? "n x n maps, jittered" : "n x n maps", 256,
                                    "%d x %d lamps", n, n);
    setting_knob(&method->setting, "lamps", (float)n);
    setting_knob(&method->setting, "jitter", (float)jitter);
    method->maps = n * n;
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "lights") == 0)
        for (int i = 0; i < STUDY_SIZES && study_sizes[i] <= 1024; i++)
            for (int across = 0; across < 2; across++) {
                Method *method =
                    method_add_map(list, LAB_ID, across ? "maps and a cube, no seams" : "maps and a cube",
                                   study_sizes[i], "%s", "");
                setting_knob(&method->setting, "cube filter", (float)across);
                method->maps = 2 + 6; // the cube's sides
            }
    if (strcmp(scene, "wide lamp") == 0)
        for (int n = 1; n <= 8; n = n < 4 ? n + 1 : n + 2)
            for (int jitter = 0; jitter < 2; jitter++)
                add_lamps(list, n, jitter);
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods}};
