// A part of a jail weakened on purpose: linked into a shim that the self-test must refuse.
#include "jail/inside/shim_filter.h"

void shim_filter(const ShimPlan *plan) {
    (void)plan;
}
