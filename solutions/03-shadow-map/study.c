// The settings of the basic shadow map in the study: one map size after the other.
#include "study/study_scene.h"

#include <string.h>

static void add_methods(MethodList *list, const char *scene) {
    bool mine = strcmp(scene, "edges") == 0 || strcmp(scene, "volumes") == 0;
    for (int i = 0; mine && i < STUDY_SIZES; i++)
        method_add_map(list, LAB_ID, "basic map", study_sizes[i], "%s", "");
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods}};
