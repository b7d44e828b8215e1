#include "study/cost.h"

#include "scene/atlas.h"
#include "study/fragments.h"

#include <stdlib.h>
#include <string.h>

// A knob of the setting; `other` where the setting leaves it alone.
static float knob(const Method *method, const char *name, float other) {
    for (int i = 0; i < method->setting.knob_count; i++)
        if (strcmp(method->setting.knobs[i].name, name) == 0)
            return method->setting.knobs[i].value;
    return other;
}

// Texels of all charts, and a ray from each of them as often as the knob says; padding is copied.
static void add_bake(Cost *cost, const Method *method, const Scene *scene) {
    Atlas *atlas = calloc(1, sizeof *atlas);
    if (atlas && atlas_layout(atlas, scene, knob(method, "texel density", 4), 1))
        for (int c = 0; c < atlas->chart_count; c++)
            cost->texels += (double)atlas->charts[c].width * atlas->charts[c].height;
    cost->rays = cost->texels * (double)knob(method, "rays", 64);
    if (atlas)
        atlas_destroy(atlas);
    free(atlas);
}

Cost cost_of(const Method *method, const Scene *scene, MetricsSize size, double partial) {
    Cost cost = {.taps = method->taps, .texels = (double)method->map_size * method->map_size};
    if (method->first > 0)
        cost.taps = method->first + partial * (method->taps - method->first);
    if (method->volumes)
        cost.fragments = fragments_of_volumes(scene, size.width, size.height);
    if (method->baked)
        add_bake(&cost, method, scene);
    return cost;
}
