// The settings of the basic shadow map in the study: one map size after the other, and in every scene the
// frame without shadows.
#include "study/study_scene.h"

#include <string.h>

// No map is drawn, and all that faces the light is lit.
static const Change bare = {
    .name = "no shadow",
    .edits = {{"lab.c",
               "    draw_scene(frame, &frame->programs[PROGRAM_DEPTH], light_clip_from_world(light), "
               "light->position);\n",
               "    UNUSED(light);\n"},
              {"lab.c", "    glClear(GL_DEPTH_BUFFER_BIT);\n", ""},
              {"shadow.frag", "float lit = visibility(v_position_world);", "float lit = 1.0;"}},
    .edit_count = 3};

static void add_bare(MethodList *list) {
    Method *method = method_add(list, LAB_ID, METHOD_BARE, "the surfaces alone");
    setting_knob(&method->setting, "map size", 64);
    method->change = &bare;
}

static void add_methods(MethodList *list, const char *scene) {
    bool mine = strcmp(scene, "edges") == 0 || strcmp(scene, "volumes") == 0;
    add_bare(list);
    for (int i = 0; mine && i < STUDY_SIZES; i++)
        method_add_map(list, LAB_ID, "basic map", study_sizes[i], "%s", "");
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods}};
