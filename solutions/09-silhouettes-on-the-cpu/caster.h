// Given: a caster as the volumes need it, and lists of triangles.
#pragma once

#include "casters.h"
#include "lab.h"

#include <stdlib.h>

enum { NOBODY = -1 };

// All places are measured from the eye, which is at (0, 0, 0) then.
typedef struct Caster {
    int triangle_count, vertex_count;
    uint32_t *corners; // three a triangle, counter-clockwise seen from outside; one number for one place
    int *neighbours;   // three a triangle: who is behind the edge from corner i to corner i + 1, or NOBODY
    vec3s *places;     // of each vertex
    bool *lit;         // of each triangle: what faces_light has said of it
    Light light;
} Caster;

// Triangles, counter-clockwise seen from outside of the volume. Corners with w = 0 are infinitely far.
typedef struct Shell {
    vec4s *corners; // three a triangle
    int count, capacity;
} Shell;

static void shell_add(Shell *shell, vec4s a, vec4s b, vec4s c) {
    if (shell->count + 3 > shell->capacity) {
        int capacity = 2 * shell->capacity + 3072;
        vec4s *corners = realloc(shell->corners, (size_t)capacity * sizeof *corners);
        if (!corners) {
            check_fail("out of memory for %d corners", capacity);
            return;
        }
        shell->corners = corners;
        shell->capacity = capacity;
    }
    shell->corners[shell->count++] = a;
    shell->corners[shell->count++] = b;
    shell->corners[shell->count++] = c;
}

static void shell_destroy(Shell *shell) {
    free(shell->corners);
    *shell = (Shell){0};
}

// The edges that leave each vertex, as lists: the first one is `first[vertex]`, then comes `next[edge]`.
static bool find_neighbours(Caster *caster) {
    int edges = 3 * caster->triangle_count;
    int *first = malloc((size_t)caster->vertex_count * sizeof *first),
        *next = malloc((size_t)edges * sizeof *next);
    for (int i = 0; first && i < caster->vertex_count; i++)
        first[i] = NOBODY;
    for (int i = 0; first && next && i < edges; i++) {
        next[i] = first[caster->corners[i]];
        first[caster->corners[i]] = i;
    }
    for (int i = 0; first && next && i < edges; i++) {
        uint32_t from = caster->corners[i], to = caster->corners[i - i % 3 + (i + 1) % 3];
        int other = first[to];
        while (other != NOBODY && caster->corners[other - other % 3 + (other + 1) % 3] != from)
            other = next[other];
        caster->neighbours[i] = other == NOBODY ? NOBODY : other / 3;
    }
    bool ok = first && next;
    free(first);
    free(next);
    return ok;
}

// `turned`: with the inside out, for a sheet that looks away from the light.
static bool caster_create(Caster *caster, Shape shape, bool turned) {
    const Mesh *mesh = casters_mesh(shape);
    const uint32_t *six = casters_adjacency(shape)->indices;
    size_t corners = (size_t)mesh->index_count, vertices = (size_t)mesh->vertex_count;
    *caster = (Caster){.triangle_count = mesh->index_count / 3,
                       .vertex_count = mesh->vertex_count,
                       .corners = malloc(corners * sizeof *caster->corners),
                       .neighbours = malloc(corners * sizeof *caster->neighbours),
                       .places = malloc(vertices * sizeof *caster->places),
                       .lit = malloc(corners / 3 * sizeof *caster->lit)};
    bool ok = caster->corners && caster->neighbours && caster->places && caster->lit;
    for (size_t i = 0; ok && i < corners; i++) {
        size_t corner = i % 3;
        caster->corners[i] = six[2 * (i - corner + (turned ? 2 - corner : corner))];
    }
    return (ok && find_neighbours(caster)) || check_fail("out of memory for a caster");
}

static void caster_destroy(Caster *caster) {
    free(caster->corners);
    free(caster->neighbours);
    free(caster->places);
    free(caster->lit);
    *caster = (Caster){0};
}

// Corner i (0, 1, 2) of a triangle.
static vec3s corner(const Caster *caster, int triangle, int i) {
    return caster->places[caster->corners[3 * triangle + i]];
}
