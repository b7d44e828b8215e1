// The shadow volume of a closed mesh, made on the CPU: the triangles that lab 07's geometry shader makes. No
// GL. Crow: Shadow Algorithms for Computer Graphics, SIGGRAPH 1977.
#pragma once

#include "scene/adjacency.h"
#include "scene/mesh.h"
#include "scene/scene.h"

#include <stdbool.h>

// Triangles, counter-clockwise seen from outside the volume.
typedef struct Volume {
    vec4s *corners;      // three a triangle, owned; in the object's space, with w = 0 for a point at infinity
    int count, capacity; // corners
} Volume;

// Adds the volume of the mesh that stands in the world so: a near cap, the triangles that face the
// light, a far cap, the same at infinity, and a side of two triangles at each edge between one that
// faces it and one that does not. The adjacency is that of the mesh, without open edges. False with a
// message when there is no memory.
bool silhouette_add(Volume *volume, const Mesh *mesh, const Adjacency *adjacency, mat4s world_from_object,
                    const Light *light);

void silhouette_destroy(Volume *volume); // accepts a zeroed volume
