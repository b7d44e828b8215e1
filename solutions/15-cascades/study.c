// Cascades in the study: four maps beside one that fits a small scene, where there is nothing to gain.
#include "study/study_scene.h"

#include <string.h>

enum { SLICES = 4 };

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "edges") != 0)
        return;
    for (int size = 256; size <= 1024; size *= 2) {
        Method *method = method_add_map(list, LAB_ID, "cascades", size, "%d slices", SLICES);
        setting_knob(&method->setting, "slices", SLICES);
        setting_knob(&method->setting, "lambda", 1);
        setting_knob(&method->setting, "blend", 0);
        method->maps = SLICES;
    }
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods}};
