// The triangles of a mesh with their neighbours, as a geometry shader with
// `triangles_adjacency` gets them. No GL.
#pragma once

#include "scene/mesh.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct Adjacency {
    // Six a triangle, owned. Corners at 0, 2, 4, counter-clockwise, of which any may be the first, as in a
    // stranger's mesh: a volume must not depend on it. Behind each corner the far corner of the triangle on
    // the other side of the edge that begins there. They number the mesh's vertices, one for all that share a
    // place.
    uint32_t *indices;
    int index_count;
    int open_edges; // edges without exactly one neighbour: 0 for a closed mesh
} Adjacency;

// A mesh has several vertices in one place (a box's corner has three normals), so edges that meet there have
// different numbers: vertices are welded by position first. An open edge gets its own triangle, turned over,
// as its neighbour.
bool adjacency_create(Adjacency *adjacency, const Mesh *mesh);
void adjacency_destroy(Adjacency *adjacency); // accepts a zeroed adjacency
