// How many volumes hold the eye? Each lit triangle alone throws a pyramid of shadow without its tip. The
// volume of the caster is all of them together: where two lie side by side, their common side is inside.
#pragma once

#include "extrude.h"

// Is the eye, which is at (0, 0, 0), in the shadow of this lit triangle alone?
static bool is_shaded_by(const Caster *caster, int triangle, float stretch) {
#ifdef SOLUTION // 9.7
    vec3s a = corner(caster, triangle, 0), b = corner(caster, triangle, 1), c = corner(caster, triangle, 2);
    vec3s light = to_light(&caster->light, vec3_make(0, 0, 0));
    vec3s normal = glms_vec3_cross(glms_vec3_sub(b, a), glms_vec3_sub(c, a));
    vec3s end = glms_vec3(far_end(&caster->light, a, stretch));
    return glms_vec3_dot(light, glms_vec3_cross(a, b)) > 0 &&
           glms_vec3_dot(light, glms_vec3_cross(b, c)) > 0 &&
           glms_vec3_dot(light, glms_vec3_cross(c, a)) > 0 && glms_vec3_dot(normal, a) > 0 &&
           glms_vec3_dot(normal, end) < 0;
#else
    // TODO(9.7): it is, if it lies on the inner side of all five faces: three sides, near cap, far cap. The
    // handout has the sign for each.
    UNUSED(caster, triangle, stretch);
    return false;
#endif
}

// The number of this caster's volumes that hold the eye: a caster that is not convex can have several.
static int count_around_eye(const Caster *caster, float stretch) {
    int count = 0;
#ifdef SOLUTION // 9.7
    for (int t = 0; t < caster->triangle_count; t++)
        count += caster->lit[t] && is_shaded_by(caster, t, stretch);
#else
    // TODO(9.7), second part: how many of its lit triangles shade the eye?
    UNUSED(caster, stretch, is_shaded_by);
#endif
    return count;
}
