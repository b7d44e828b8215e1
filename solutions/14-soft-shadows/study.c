// Soft shadows of one map under lab 10's wide lamp: more and more taps, smaller and larger maps.
#include "study/study_scene.h"

#include <string.h>

static void add_soft(MethodList *list, int size, int search, int filter) {
    Method *method = method_add_map(list, LAB_ID, "percentage-closer soft shadows", size, "%d + %d taps",
                                    search * search, filter * filter);
    setting_knob(&method->setting, "search taps", (float)search);
    setting_knob(&method->setting, "filter taps", (float)filter);
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "wide lamp") != 0)
        return;
    for (int taps = 2; taps <= 16; taps *= 2)
        add_soft(list, 512, taps < 8 ? taps : 8, taps);
    add_soft(list, 256, 8, 8);
    add_soft(list, 1024, 8, 8);
    add_soft(list, 1024, 16, 16);
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods, .contest = {LAB_ID, "wide lamp", 0.002}}};
