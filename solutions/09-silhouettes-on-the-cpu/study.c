// Volumes made on the CPU in the study: two ways to find the silhouette, three to count, and volumes that
// end.
#include "study/study_scene.h"

#include <string.h>

// Values of the knob "method", and the families' names.
static const char *const families[] = {"z-pass volumes, from 0", "z-pass volumes, from the eye",
                                       "z-fail volumes"};
enum { FROM_ZERO, FROM_EYE, Z_FAIL };

// `stretch`: the volumes end there, in ways from the light; 0: they have no end.
static void add(MethodList *list, int way, int by_neighbours, float stretch) {
    static const char *const finders[] = {"edge set", "neighbours"};
    Method *method = stretch > 0
                         ? method_add(list, LAB_ID, families[way], "%s on the CPU, stretch %g",
                                      finders[by_neighbours], (double)stretch)
                         : method_add(list, LAB_ID, families[way], "%s on the CPU", finders[by_neighbours]);
    setting_knob(&method->setting, "method", (float)way);
    setting_knob(&method->setting, "silhouettes", (float)by_neighbours);
    setting_knob(&method->setting, "stretch", stretch);
}

static void add_methods(MethodList *list, const char *scene) {
    if (strcmp(scene, "volumes") != 0)
        return;
    for (int by_neighbours = 0; by_neighbours < 2; by_neighbours++)
        for (int way = FROM_EYE; way <= Z_FAIL; way++)
            add(list, way, by_neighbours, 0);
    add(list, FROM_ZERO, 0, 0);
    add(list, FROM_EYE, 0, 0.25f);
    add(list, Z_FAIL, 0, 4);
}

const LabStudy LAB_TABLE[] = {{.add_methods = add_methods}};
