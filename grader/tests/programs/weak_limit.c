// A part of a jail weakened on purpose: linked into a shim that the self-test must refuse.
#include "jail/inside/shim_limit.h"

void shim_limit(const ShimPlan *plan) {
    (void)plan;
}
