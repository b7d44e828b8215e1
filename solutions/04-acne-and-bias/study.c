// The cures of acne in the study, and the scene that tells them apart.
#include "study/study_scene.h"
#include "truth/closed_scenes.h"

#include <stdio.h>
#include <string.h>

// A floor with bumps of several slopes and a thin wall, under a low sun: what needs a bias, and what a bias
// detaches.
static void make_bias(Scene *scene) {
    *scene = (Scene){0};
    study_look(scene, vec3_make(0.9f, 3.9f, 4.1f), vec3_make(-0.25f, 0.1f, 0));
    // A slab, not a sheet: front-face culling would leave a sheet out of the map and look cheap.
    closed_add(scene, SHAPE_BOX, vec3_make(0, -0.2f, 0), vec3_make(3.4f, 0.2f, 3.4f), 0);
    for (int i = 0; i < 3; i++)
        study_add_turned(scene, SHAPE_BOX, vec3_make(-1.9f, -0.1f, 1.4f * (float)i - 1.6f),
                         vec3_make(0.4f, 0.4f, 0.5f), 15 + 15 * (float)i);
    closed_add(scene, SHAPE_BOX, vec3_make(0.4f, 0.45f, 0), vec3_make(0.02f, 0.45f, 1.3f), 12);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(-8, 5.6f, 2), vec3_make(0, 0, 0), 0, 3.6f, 4, 16);
}

static const StudyScene scenes[] = {
    {"bias",
     "Hard light on slopes: bias",
     "slopes that shadow themselves, and a thin wall that a bias detaches",
     make_bias,
     {.kind = TRUTH_LIGHT},
     true,
     STUDY_HARD,
     .moves = true},
    {0},
};

// Values of the knob "method".
enum { NONE, CONSTANT, SLOPE, OFFSET, FACES, NORMAL };

// As in lab 05, each method is measured in a shader in which the choice is fixed.
#define FIX(method)                                                                                          \
    {                                                                                                        \
        .name = "method " #method " fixed",                                                                  \
        .edits = {{"shadow.frag", "uniform int u_method;", "const int u_method = " #method ";"}},            \
        .edit_count = 1                                                                                      \
    }
static const Change fixed[] = {FIX(0), FIX(1), FIX(2), FIX(3), FIX(4), FIX(5)};

// `format` names the knob's value.
static Setting *add_bias(MethodList *list, int size, const char *family, int method, const char *knob,
                         float value, const char *format) {
    char name[METHOD_NAME];
    snprintf(name, sizeof name, format, (double)value);
    Method *added = method_add_map(list, LAB_ID, family, size, "%s", name);
    Setting *setting = &added->setting;
    added->change = &fixed[method];
    setting_knob(setting, "method", (float)method);
    if (knob)
        setting_knob(setting, knob, value);
    return setting;
}

static void add_biases(MethodList *list, int size) {
    add_bias(list, size, "no bias", NONE, NULL, 0, "");
    add_bias(list, size, "constant bias", CONSTANT, "bias", 0.002f, "bias %g");
    add_bias(list, size, "constant bias", CONSTANT, "bias", 0.01f, "bias %g");
    Setting *slope = add_bias(list, size, "slope bias", SLOPE, "slope bias", 0.03f, "slope bias %g");
    setting_knob(slope, "bias", 0.001f);
    add_bias(list, size, "polygon offset", OFFSET, "factor", 1, "factor %g");
    add_bias(list, size, "polygon offset", OFFSET, "factor", 2, "factor %g");
    add_bias(list, size, "front faces culled", FACES, NULL, 0, "");
    add_bias(list, size, "normal offset", NORMAL, "normal offset", 0.5f, "%g texels");
    add_bias(list, size, "normal offset", NORMAL, "normal offset", 1, "%g texel");
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "bias") != 0)
        return;
    for (int i = 0; i < STUDY_SIZES; i++)
        add_biases(list, study_sizes[i]);
    for (int bits = 16; bits <= 32; bits += 16) {
        Setting *setting =
            add_bias(list, 1024, "polygon offset", OFFSET, "factor", 2,
                     bits == 16 ? "factor %g, 16 bits of depth" : "factor %g, 32 bits of depth");
        setting_knob(setting, "depth format", (float)bits);
    }
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods}};
