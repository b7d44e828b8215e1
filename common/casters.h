// Drawing what casts shadow volumes: the scene's closed objects, each triangle with its neighbours
// (adjacency.h). An open mesh, like the floor, has no inside and so no volume: it receives shadows and casts
// none.
#pragma once

#include "draw.h"

#include <stdbool.h>

typedef struct Casters {
    struct {
        GLuint vertex_array, buffers[2];
        GLsizei index_count; // 0 for an open shape
    } shapes[SHAPE_COUNT];
} Casters;

bool casters_create(Casters *casters);
void casters_destroy(Casters *casters); // accepts zeroed casters

// Draws the closed objects as GL_TRIANGLES_ADJACENCY with the program that draw_begin has made ready; sets
// u_world_from_object. Vertices have a position only (attribute 0).
void casters_draw(const Casters *casters, const Frame *frame, const Program *program);
