// Variance maps in the study: blurs beside box PCF of the same width where one width fits, and under lab 10's
// wide lamp.
#include "study/study_scene.h"

#include <string.h>

static void add_blur(MethodList *list, int size, int radius) {
    Method *method = method_add_map(list, LAB_ID, "variance map", size, "blur of %d", 2 * radius + 1);
    setting_knob(&method->setting, "blur", (float)radius);
    method->kernel = (float)radius;
    method->map_bytes = 20; // two floats, twice, and the depth
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "penumbra") == 0)
        for (int size = 256; size <= 1024; size *= 2)
            add_blur(list, size, size / (int)STUDY_KERNEL);
    if (strcmp(scene, "wide lamp") == 0)
        for (int radius = 2; radius <= 8; radius *= 2)
            add_blur(list, 512, radius);
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods}};
