// Flattened casters in the study: a hard lamp beside maps and volumes, and a wide one as more and more lamps.
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <string.h>

// A floor and a wall under a lamp.
static void make_planes(Scene *scene) {
    *scene = (Scene){0};
    study_look(scene, vec3_make(0.4f, 3.4f, 6.2f), vec3_make(0, 0.5f, -0.4f));
    closed_add(scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(4, 1, 4), 0);
    closed_stand(scene, vec3_make(0, 1.5f, -2.2f), 4, 1.5f, 0);
    closed_light(scene, LIGHT_SPOT, vec3_make(0.6f, 5, 4), vec3_make(0, 0.4f, -0.4f), glm_rad(70), 0, 1, 14);
}

// A caster whose edges run in all directions; its shadow lies on both planes.
static void make_flat(Scene *scene) {
    make_planes(scene);
    closed_add(scene, SHAPE_SPHERE, vec3_make(0, 2.2f, 0.4f), vec3_make(0.45f, 0.45f, 0.45f), 0);
}

// Casters at three heights, none of which shades another, under a lamp of side 0.8.
static void make_soft(Scene *scene) {
    make_planes(scene);
    closed_add(scene, SHAPE_BOX, vec3_make(-1.6f, 0.45f, 0.3f), vec3_make(0.4f, 0.3f, 0.4f), 30);
    closed_add(scene, SHAPE_SPHERE, vec3_make(0, 1.1f, 0.4f), vec3_make(0.45f, 0.45f, 0.45f), 0);
    closed_add(scene, SHAPE_BOX, vec3_make(1.6f, 0.8f, 0), vec3_make(0.35f, 0.35f, 0.35f), 15);
    scene->lights[0].extent = 0.4f;
}

static const StudyScene scenes[] = {
    {"planes",
     "Hard light on floor and wall: flattened casters",
     "two planes that receive, and one caster",
     make_flat,
     {.kind = TRUTH_LIGHT},
     true,
     STUDY_HARD,
     .moves = false},
    {"wide lamp",
     "A wide lamp over floor and wall: n x n lamps",
     "penumbrae that widen with the distance from caster to receiver",
     make_soft,
     {.kind = TRUTH_LIGHT, .samples = 1024, .seed = 1},
     true,
     STUDY_SOFT,
     .moves = false},
    {0},
};

enum { PICTURE_BYTES = 12 }; // the light that is taken, depth and stencil, and a colour to look at

static void add_lamps(MethodList *list, int n, int jitter) {
    Method *method =
        method_add(list, LAB_ID, jitter ? "flattened, jittered lamps" : "flattened, regular lamps",
                   "%d x %d lamps", n, n);
    setting_knob(&method->setting, "lamps", (float)n);
    setting_knob(&method->setting, "jitter", (float)jitter);
    method->picture_bytes = PICTURE_BYTES;
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "planes") == 0) {
        method_add(list, LAB_ID, "flattened casters", "exact edges")->picture_bytes = PICTURE_BYTES;
        for (int i = 0; i < STUDY_SIZES; i++)
            method_add_map(list, "03", "basic map", study_sizes[i], "%s", "");
        Method *volumes = method_add(list, "07", "z-fail volumes", "geometry shader");
        volumes->picture_bytes = 12; // as in lab 07
    }
    if (strcmp(scene, "wide lamp") == 0)
        for (int n = 1; n <= 16; n *= 2)
            for (int jitter = 0; jitter < 2; jitter++)
                add_lamps(list, n, jitter);
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods}};
