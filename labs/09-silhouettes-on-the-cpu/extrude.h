// From the silhouette to a closed volume: sides and caps. And is the eye in it?
#pragma once

#include "edges.h"

// Where the shadow of p ends, (x, y, z, w). `stretch` times as far behind p as p is from the light (for the
// sun: as its position is from its target); 0: the volume has no end.
static vec4s far_end(const Light *light, vec3s p, float stretch) {
    vec3s away = glms_vec3_negate(to_light(light, p));
    // TODO(9.5): without an end (stretch is 0) p goes to infinity. Which w has a point at infinity?
    // TODO(9.4): go from p as far away from the light as `stretch` says. Look up: glms_vec3_muladds.
    UNUSED(away, stretch);
    return glms_vec4(p, 1);
}

// The side of the volume behind an edge of the silhouette: two triangles.
static void add_side(Shell *shell, const Caster *caster, Edge edge, float stretch) {
    vec3s a = caster->places[edge.a], b = caster->places[edge.b];
    vec4s near_a = glms_vec4(a, 1), near_b = glms_vec4(b, 1);
    vec4s far_a = far_end(&caster->light, a, stretch), far_b = far_end(&caster->light, b, stretch);
    // TODO(9.4), second part: the four corners as two triangles, counter-clockwise seen from outside. The lit
    // triangle is to the left of the way from a to b. Look up: shell_add in caster.h.
    UNUSED(shell, near_a, near_b, far_a, far_b);
}

// What closes the volume: its beginning at each lit triangle, and its end.
static void add_caps(Shell *shell, const Caster *caster, int triangle, float stretch) {
    // TODO(9.6): the near cap is the triangle itself; the far cap is the same at its far end, and looks the
    // other way. Look up: corner in caster.h.
    UNUSED(shell, caster, triangle, stretch);
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
    // TODO(9.7): it is, if it lies on the inner side of all five faces: three sides, near cap, far cap. The
    // handout has the sign for each. L is the way from (0, 0, 0), A' the first three numbers of the far end.
    // Look up: to_light, far_end, is_within.
    UNUSED(caster, triangle, stretch, is_within);
    return false;
}

// The number of this caster's volumes that hold the eye: a caster that is not convex can have several.
static int count_around_eye(const Caster *caster, float stretch) {
    int count = 0;
    // TODO(9.7), second part: how many of its lit triangles shade the eye?
    UNUSED(caster, stretch, is_shaded_by);
    return count;
}
