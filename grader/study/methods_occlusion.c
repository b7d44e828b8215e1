// The settings of lab 08.
#include "study/method.h"

#include "scene/count.h"

static void add_baked(MethodList *list, int density, int rays) {
    Method *method = method_add(list, "08", "baked", "%d texels a unit, %d rays", density, rays);
    setting_knob(&method->setting, "texel density", (float)density);
    setting_knob(&method->setting, "rays", (float)rays);
    method->baked = true;
}

void methods_of_occlusion(MethodList *list) {
    const float radii[] = {0.25f, 0.5f, 1};
    for (int density = 2; density <= 16; density *= 2)
        for (int rays = 4; rays <= 256 && density * density * rays <= 16384; rays *= 4)
            add_baked(list, density, rays);
    for (unsigned i = 0; i < COUNT(radii); i++) {
        Method *method = method_add(list, "08", "screen space", "radius %g", (double)radii[i]);
        setting_knob(&method->setting, "method", 1);
        setting_knob(&method->setting, "ray length", radii[i]);
        method->taps = 16; // hemisphere_count in shaders/hemisphere.glsl
    }
}
