// Shadow volumes in the study, and the scene in which the eye stands in one.
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <string.h>

// Closed casters under a lamp behind the camera, and a plate that keeps the lamp from the eye: it stands in a
// volume.
static void make_volumes(Scene *scene) {
    const vec3s eye = vec3_make(0.2f, 2.7f, 4.7f), lamp = vec3_make(4.2f, 5, 4.6f);
    *scene = (Scene){0};
    study_look(scene, eye, vec3_make(-0.35f, 0.15f, 0));
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(4, 1, 4), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(-1, 0.6f, 0.4f), vec3_make(0.5f, 0.6f, 0.5f), 30);
    closed_add(scene, SHAPE_SPHERE, vec3_make(0.9f, 0.9f, -0.3f), vec3_make(0.55f, 0.55f, 0.55f), 0);
    closed_add(scene, SHAPE_BOX, glms_vec3_lerp(eye, lamp, 0.5f), vec3_make(0.3f, 0.05f, 0.3f), 20); // PLATE
    closed_light(scene, LIGHT_SPOT, lamp, vec3_make(-0.2f, 0.6f, 0), glm_rad(60), 0, 1, 18);
}

enum { PLATE = 3 };

// The plate stays between eye and lamp.
static void settle(Scene *scene, const char *name) {
    if (strcmp(name, "volumes") != 0)
        return;
    vec3s middle = glms_vec3_lerp(scene->camera.eye, scene->lights[0].position, 0.5f);
    for (int c = 0; c < 3; c++)
        scene->objects[PLATE].world_from_object.raw[3][c] = middle.raw[c];
}

static const StudyScene scenes[] = {
    {"volumes",
     "The eye in a shadow: volumes and maps",
     "closed casters; the eye stands in a volume",
     make_volumes,
     {.kind = TRUTH_LIGHT},
     true,
     STUDY_HARD,
     .moves = true},
    {0},
};

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "volumes") != 0)
        return;
    for (int z_fail = 0; z_fail < 2; z_fail++)
        for (int on_cpu = 0; on_cpu < 2; on_cpu++) {
            Method *method = method_add(list, LAB_ID, z_fail ? "z-fail volumes" : "z-pass volumes", "%s",
                                        on_cpu ? "silhouettes on the CPU" : "geometry shader");
            setting_knob(&method->setting, "method", (float)z_fail);
            setting_knob(&method->setting, "silhouettes", (float)on_cpu);
            method->picture_bytes = 12; // two colours of 4 bytes, depth and stencil
        }
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods, .settle = settle}};
