#include "study/cost.h"

#include "study/fragments.h"

Cost cost_of(const Method *method, const Scene *scene, MetricsSize size, double partial) {
    Cost cost = {.taps = method->taps, .texels = (double)method->map_size * method->map_size};
    if (method->first > 0)
        cost.taps = method->first + partial * (method->taps - method->first);
    if (method->volumes)
        cost.fragments = fragments_of_volumes(scene, size.width, size.height);
    if (method->add_cost)
        method->add_cost(&cost, method, scene);
    return cost;
}
