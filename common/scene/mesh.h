// Triangle meshes of the unit shapes. No GL.
#pragma once

#include "scene/mathx.h"

#include <stdbool.h>
#include <stdint.h>

typedef enum Shape {
    SHAPE_PLANE,  // [-1, 1] x {0} x [-1, 1], facing +y, one-sided, texture coordinates with v growing towards
                  // -z
    SHAPE_BOX,    // [-1, 1]^3, closed
    SHAPE_SPHERE, // radius 1, closed, 32 x 16 quads
    SHAPE_ARCH,   // [-1, 1]^3 without the gate |x| < 1/2, y < 1/2, closed, not convex; no texture coordinates
    SHAPE_COUNT
} Shape;

typedef struct Vertex {
    vec3s position, normal;
    vec2s uv;
} Vertex;

// Triangles are counter-clockwise seen from outside.
typedef struct Mesh {
    Vertex *vertices;  // vertex_count, owned
    uint32_t *indices; // index_count = 3 * triangles, owned
    int vertex_count, index_count;
} Mesh;

// Makes a unit shape. False when there is no memory.
bool mesh_create(Mesh *mesh, Shape shape);
void mesh_destroy(Mesh *mesh); // accepts a zeroed mesh
