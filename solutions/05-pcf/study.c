// The filters in the study, and the scene that shows texels and filters.
#include "study_filters.h"
#include "study_receiver_plane.h"
#include "scene/count.h"
#include "truth/closed_scenes.h"

#include <string.h>

// Plates before a wall, both square to the light: no bias is needed, and the edge shows the map's texels and
// its filter alone, in many directions.
void filters_make_edges(Scene *scene) {
    *scene = closed_wall(3.2f, 10, glm_rad(36));
    study_look(scene, vec3_make(2.7f, 0.7f, 4.3f), vec3_make(0.1f, 0, 0));
    for (int i = 0; i < 4; i++)
        study_add_turned(scene, SHAPE_BOX, vec3_make(i % 2 ? 0.9f : -0.9f, i / 2 ? 0.7f : -0.7f, 0.8f),
                         vec3_make(0.7f, 0.3f, 0.01f), 8 + 23 * (float)i);
    closed_light(scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, 10), vec3_make(0, 0, 0), 0, 3.2f, 4, 16);
}

static const StudyScene scenes[] = {
    {"edges",
     "Hard light on plates: texels and filters",
     "long edges in many directions: the texels show, and what a filter makes of them",
     filters_make_edges,
     {.kind = TRUTH_LIGHT},
     true,
     STUDY_HARD,
     .moves = false},
    {0},
};

static const Filter hard = {"hard", 0, 0, 0}, by_hand = {"3 x 3 by hand", 1, 0, 1},
                    diagonals = {"4 diagonals", 3, 0, 1};

// llvmpipe walks all branches of a shader, whatever a uniform chooses, so each filter is measured in a shader
// in which the choice is fixed, as a course or a game would build it.
#define FIX(method)                                                                                          \
    { .name = "method " #method " fixed", .edits = {FILTER_FIXED(#method)}, .edit_count = 1 }
const Change filters_fixed[FILTERS_FIXED] = {FIX(0), FIX(1), FIX(2), FIX(3), FIX(4), FIX(5)};

// The offset that one linear lookup needs; the planes do the rest of the kernel.
static const Change receiver_plane = {
    .name = "box by receiver planes",
    .edits = {FILTER_FIXED("4"),
              {"lab.c", "glPolygonOffset(2 * reach, 2)", "glPolygonOffset(2 + 0 * reach, 2)"},
              RECEIVER_PLANE},
    .edit_count = 4};

Method *filters_add(MethodList *list, Filter filter, int size) {
    Method *method = method_add_map(list, LAB_ID, filter.family, size, "%s", "");
    setting_knob(&method->setting, "method", (float)filter.method);
    method->change = &filters_fixed[filter.method];
    if (filter.radius > 0)
        setting_knob(&method->setting, "kernel radius", (float)filter.radius);
    method->kernel = filter.kernel;
    return method;
}

static Method *add_box(MethodList *list, const char *family, int size, int radius) {
    int side = 2 * radius + 1;
    Method *method = method_add_map(list, LAB_ID, family, size, "%d x %d", side, side);
    setting_knob(&method->setting, "method", 4);
    method->change = &filters_fixed[4];
    setting_knob(&method->setting, "kernel radius", (float)radius);
    method->kernel = (float)radius;
    return method;
}

// Two ways to keep acne off a wide kernel: an offset that grows with it, and the receiver's plane.
static void add_to_bias(MethodList *list) {
    for (int i = 0; i < STUDY_SIZES; i++) {
        add_box(list, "box, offset by its kernel", study_sizes[i], 2);
        add_box(list, "box, receiver plane", study_sizes[i], 2)->change = &receiver_plane;
    }
}

// No one kernel fits penumbrae of several widths.
static void add_to_wide_lamp(MethodList *list) {
    for (int radius = 2; radius <= 8; radius += 2)
        add_box(list, "box PCF", 256, radius);
}

static void add_to_edges(MethodList *list) {
    const Filter filters[] = {hard, by_hand, filter_linear, diagonals, filter_box_5, filter_gather};
    for (int i = 0; i < STUDY_SIZES; i++)
        for (unsigned f = 0; f < COUNT(filters); f++)
            filters_add(list, filters[f], study_sizes[i]);
}

static void add_to_penumbra(MethodList *list) {
    filters_add(list, hard, 1024);
    filters_add(list, filter_linear, 256);
    for (int size = 128; size <= 512; size *= 2)
        add_box(list, "box PCF", size, size / STUDY_KERNEL);
}

static void add_to_volumes(MethodList *list) {
    for (int i = 0; i < STUDY_SIZES; i++) {
        filters_add(list, filter_linear, study_sizes[i]);
        filters_add(list, filter_gather, study_sizes[i]);
    }
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "edges") == 0)
        add_to_edges(list);
    if (strcmp(scene, "penumbra") == 0)
        add_to_penumbra(list);
    if (strcmp(scene, "volumes") == 0)
        add_to_volumes(list);
    if (strcmp(scene, "bias") == 0)
        add_to_bias(list);
    if (strcmp(scene, "wide lamp") == 0)
        add_to_wide_lamp(list);
}

// The light stays square to the wall; that it moved along it moves the map's grid.
static void settle(Scene *scene, const char *name) {
    if (strcmp(name, "edges") == 0 || strcmp(name, FASTER) == 0)
        scene->lights[0].position = glms_vec3_add(scene->lights[0].target, vec3_make(0, 0, 10));
}

const LabStudy LAB_TABLE[] = {{.scenes = scenes, .add_methods = add_methods, .settle = settle}};
