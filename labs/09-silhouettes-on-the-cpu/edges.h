// The silhouette: the edges between what looks to the light and what does not.
#pragma once

#include "caster.h"

// From vertex a to vertex b, the way round the lit triangle goes: counter-clockwise seen from outside.
typedef struct Edge {
    uint32_t a, b;
} Edge;

// In any order. There is room for three edges of each triangle.
typedef struct EdgeSet {
    Edge *edges;
    int count;
} EdgeSet;

// From p towards the light. A lamp is at light->position; the sun (LIGHT_DIRECTIONAL) shines from there to
// light->target, everywhere in this direction. As long as the way is: far_end needs its length.
static vec3s to_light(const Light *light, vec3s p) {
    // TODO(9.1): the difference of two places. Look up: glms_vec3_sub.
    UNUSED(light, p);
    return vec3_make(0, 1, 0);
}

// Does the triangle, counter-clockwise a, b, c, look to the light?
static bool faces_light(const Light *light, vec3s a, vec3s b, vec3s c) {
    // TODO(9.1), second part: its normal is the cross product of two sides; the sign of the dot product with
    // the way to the light decides. Look up: glms_vec3_cross, glms_vec3_dot.
    UNUSED(light, a, b, c, to_light);
    return true;
}

// An edge that comes for the second time, by the triangle on its other side, goes out of the set. Others go
// in.
static void toggle(EdgeSet *set, Edge edge) {
    // TODO(9.2): look for the same edge. Which way round does the other triangle go along it? Take it out:
    // the last of the set may come to its place. Then do not add.
    set->edges[set->count++] = edge;
}

// Lecture 004: all edges of all lit triangles are toggled.
static void find_by_set(EdgeSet *set, const Caster *caster) {
    for (int t = 0; t < caster->triangle_count; t++)
        for (int i = 0; caster->lit[t] && i < 3; i++) {
            const uint32_t *corners = caster->corners + 3 * t;
            toggle(set, (Edge){corners[i], corners[(i + 1) % 3]});
        }
}

// Lecture 001: whoever knows the neighbours needs no search.
static void find_by_neighbours(EdgeSet *set, const Caster *caster) {
    // TODO(9.3): an edge of a lit triangle is on the silhouette when the triangle behind it is not lit, or
    // when nobody is behind it. caster->neighbours[3 * t + i] says who is behind edge i of triangle t.
    UNUSED(set, caster);
}
