// Volumes made on the CPU in the study: two ways to find the silhouette, and z-pass with the number around
// the eye.
#include "study/study_scene.h"

#include <string.h>

static void add_methods(MethodList *list, const char *scene) {
    static const char *const names[] = {"z-pass volumes, from the eye", "z-fail volumes"};
    if (strcmp(scene, "volumes") != 0)
        return;
    for (int by_neighbours = 0; by_neighbours < 2; by_neighbours++)
        for (int z_fail = 0; z_fail < 2; z_fail++) {
            Method *method = method_add(list, LAB_ID, names[z_fail], "%s on the CPU",
                                        by_neighbours ? "neighbours" : "edge set");
            setting_knob(&method->setting, "method", (float)(1 + z_fail));
            setting_knob(&method->setting, "silhouettes", (float)by_neighbours);
            method->volumes = true;
            method->taps = 0;
        }
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods}};
