#include "study/cost.h"

#include "study/fragments.h"

// What each costs, in lookups of a texel. A model that no GPU keeps to: a written texel and a fragment that
// only counts in the stencil cost about as much as a lookup, a ray through a small scene a hundred times
// that.
static const double RAY = 100;

static int map_texel_bytes(const Method *method) {
    return method_knob(method, "depth format", 32) <= 16 ? 2 : 4; // 24 bits lie in 32
}

// Bytes and the one number, from all that was counted.
static void sum_up(Cost *cost, const Method *method, double pixels) {
    const double map = (double)method->map_size * method->map_size, atlas = cost->texels - map;
    cost->bytes =
        map * map_texel_bytes(method) + atlas * method->texel_bytes + pixels * method->picture_bytes;
    cost->counted = cost->texels + cost->taps * pixels + cost->fragments + RAY * cost->rays;
}

Cost cost_of(const Method *method, const Scene *scene, MetricsSize size, double partial) {
    Cost cost = {.taps = method->taps, .texels = (double)method->map_size * method->map_size};
    if (method->first > 0)
        cost.taps = method->first + partial * (method->taps - method->first);
    if (method->volumes)
        cost.fragments = fragments_of_volumes(scene, size.width, size.height);
    if (method->add_cost)
        method->add_cost(&cost, method, scene);
    sum_up(&cost, method, (double)size.width * size.height);
    return cost;
}
