#include "study/cost.h"

// A read, a fragment and a texel that is written weigh the same, a ray through a small scene a hundred times
// that: no machine keeps to it, and all share it.
static const double RAY = 100;

static int map_texel_bytes(const Method *method) {
    if (method->map_bytes > 0)
        return method->map_bytes;
    return method_knob(method, "depth format", 32) <= 16 ? 2 : 4; // 24 bits lie in 32
}

Cost cost_of(const Method *method, const Scene *scene, MetricsSize size, const MeasuredErrors *counted) {
    const double pixels = (double)size.width * size.height;
    Cost cost = {.taps = counted->reads / pixels, .fragments = counted->fragments};
    if (method->add_cost)
        method->add_cost(&cost, method, scene);
    cost.texels = counted->cleared + cost.atlas;
    cost.held = (double)method->maps * method->map_size * method->map_size * map_texel_bytes(method) +
                cost.atlas * method->texel_bytes;
    cost.bytes = cost.held + pixels * method->picture_bytes;
    cost.counted = counted->reads + cost.fragments + cost.texels + RAY * cost.rays;
    return cost;
}
