// A part of a jail weakened on purpose: linked into a shim that the self-test must refuse.
#include "jail/inside/shim_files.h"

void shim_hide_files(const ShimPlan *plan) {
    (void)plan;
}
