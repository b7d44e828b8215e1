// A mesh on the GPU.
#pragma once

#include "gl.h"
#include "scene/mesh.h"

typedef struct Model {
    GLuint vertex_array, buffers[2];
    GLsizei index_count;
} Model;

// Uploads the mesh's vertices (attributes 0: position, 1: normal, 2: texture coordinates) with these indices,
// which are the mesh's own or, for instance, those of its adjacency.
void model_create(Model *model, const Mesh *mesh, const uint32_t *indices, int index_count);
void model_destroy(Model *model); // accepts a zeroed model
