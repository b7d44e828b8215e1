// Drawing what casts shadow volumes: the scene's closed objects, each triangle with its neighbours
// (adjacency.h). An open mesh, like the floor, has no inside and so no volume: it receives shadows and casts
// none.
#pragma once

#include "draw.h"

// Draws the closed objects as GL_TRIANGLES_ADJACENCY with the program that draw_begin has made ready; sets
// u_world_from_object. The vertices are those of model.h. The meshes are made at the first call and
// live as long as the context.
void casters_draw(const Frame *frame, const Program *program);

// Makes the volumes of light 0 on the CPU (silhouette.h) and draws them as GL_TRIANGLES with the program that
// draw_begin has made ready; its vertex shader is volume.vert.
void casters_draw_volumes(const Frame *frame);
