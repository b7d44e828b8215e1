// How many volumes hold the eye? Each lit triangle alone throws a pyramid of shadow without its tip. The
// volume of the caster is all of them together: where two lie side by side, their common side is inside.
#pragma once

#include "extrude.h"

// Is the eye, which is at (0, 0, 0), in the shadow of this lit triangle alone?
static bool is_shaded_by(const Caster *caster, int triangle, float stretch) {
    // TODO(9.7): it is, if it lies on the inner side of all five faces: three sides, near cap, far cap. The
    // handout has the sign for each.
    UNUSED(caster, triangle, stretch);
    return false;
}

// The number of this caster's volumes that hold the eye: a caster that is not convex can have several.
static int count_around_eye(const Caster *caster, float stretch) {
    int count = 0;
    // TODO(9.7), second part: how many of its lit triangles shade the eye?
    UNUSED(caster, stretch, is_shaded_by);
    return count;
}
