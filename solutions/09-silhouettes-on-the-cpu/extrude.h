// From the silhouette to a closed volume: sides and caps. And is the eye in it?
#pragma once

#include "edges.h"

// Where the shadow of p ends, (x, y, z, w). `stretch` times as far behind p as p is from the light (for the
// sun: as its position is from its target); 0: the volume has no end.
static vec4s far_end(const Light *light, vec3s p, float stretch) {
    vec3s away = glms_vec3_negate(to_light(light, p));
#ifdef SOLUTION // 9.5
    if (stretch == 0)
        return glms_vec4(away, 0);
#else
    // TODO(9.5): without an end (stretch is 0) p goes to infinity. Which w has a point at infinity?
#endif
#ifdef SOLUTION // 9.4
    return glms_vec4(glms_vec3_muladds(away, stretch, p), 1);
#else
    // TODO(9.4): go from p as far away from the light as `stretch` says. Look up: glms_vec3_muladds.
    UNUSED(away, stretch);
    return glms_vec4(p, 1);
#endif
}

// The side of the volume behind an edge of the silhouette: two triangles.
static void add_side(Shell *shell, const Caster *caster, Edge edge, float stretch) {
    vec3s a = caster->places[edge.a], b = caster->places[edge.b];
    vec4s near_a = glms_vec4(a, 1), near_b = glms_vec4(b, 1);
    vec4s far_a = far_end(&caster->light, a, stretch), far_b = far_end(&caster->light, b, stretch);
#ifdef SOLUTION // 9.4
    shell_add(shell, near_a, far_a, near_b);
    shell_add(shell, near_b, far_a, far_b);
#else
    // TODO(9.4), second part: the four corners as two triangles, counter-clockwise seen from outside. The lit
    // triangle is to the left of the way from a to b. Look up: shell_add in caster.h.
    UNUSED(shell, near_a, near_b, far_a, far_b);
#endif
}

// What closes the volume: its beginning at each lit triangle, and its end.
static void add_caps(Shell *shell, const Caster *caster, int triangle, float stretch) {
#ifdef SOLUTION // 9.6
    vec4s far[3], near[3];
    for (int i = 0; i < 3; i++) {
        near[i] = glms_vec4(corner(caster, triangle, i), 1);
        far[i] = far_end(&caster->light, corner(caster, triangle, i), stretch);
    }
    shell_add(shell, near[0], near[1], near[2]);
    shell_add(shell, far[0], far[2], far[1]);
#else
    // TODO(9.6): the near cap is the triangle itself; the far cap is the same at its far end, and looks the
    // other way. Look up: corner in caster.h.
    UNUSED(shell, caster, triangle, stretch);
#endif
}

// Given: L . (A x B) > 0. Where it is 0 the eye looks to the light exactly along an edge that two triangles
// share, and must count for one of them: the light is moved then, by a little.
static bool is_within(vec3s light, vec3s a, vec3s b) {
    vec3s side = glms_vec3_cross(a, b);
    float within = glms_vec3_dot(light, side);
    return within != 0 ? within > 0 : glms_vec3_dot(vec3_make(0.3f, 0.5f, 0.8f), side) > 0;
}

// A lit triangle alone throws a pyramid of shadow without its tip; the volume of a caster is all of them
// together. Is the eye, which is at (0, 0, 0), in the shadow of this lit triangle alone?
static bool is_shaded_by(const Caster *caster, int triangle, float stretch) {
#ifdef SOLUTION // 9.7
    vec3s a = corner(caster, triangle, 0), b = corner(caster, triangle, 1), c = corner(caster, triangle, 2);
    vec3s light = to_light(&caster->light, vec3_make(0, 0, 0));
    vec3s normal = glms_vec3_cross(glms_vec3_sub(b, a), glms_vec3_sub(c, a));
    vec3s end = glms_vec3(far_end(&caster->light, a, stretch));
    bool is_between = glms_vec3_dot(normal, a) > 0 && glms_vec3_dot(normal, end) < 0;
    return is_between && is_within(light, a, b) && is_within(light, b, c) && is_within(light, c, a);
#else
    // TODO(9.7): it is, if it lies on the inner side of all five faces: three sides, near cap, far cap. The
    // handout has the sign for each. L is the way from (0, 0, 0), A' the first three numbers of the far end.
    // Look up: to_light, far_end, is_within.
    UNUSED(caster, triangle, stretch, is_within);
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
