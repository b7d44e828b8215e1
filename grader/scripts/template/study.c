// The settings of this lab in the study (speed against error), in scenes of its own or of other labs.
#include "study/study_scene.h"

#include <string.h>

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "edges") == 0)
        method_add(list, LAB_ID, "@NAME@", "as it is");
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods}};
