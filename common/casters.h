// Drawing what casts shadow volumes: the scene's closed objects, each triangle with its
// neighbours (adjacency.h). An open mesh, like the floor, has no inside and so no volume: it
// receives shadows and casts none.
#pragma once

#include "draw.h"

#include <stdbool.h>

// Makes the meshes on the GPU; a lab calls both in its create and destroy, before and after it draws casters.
// False with a message when there is no memory; casters_destroy accepts what was not made, or only in part.
bool casters_create(void);
void casters_destroy(void);

// Draws the closed objects as GL_TRIANGLES_ADJACENCY with the program that draw_begin has made ready; sets
// u_world_from_object. The vertices are those of model.h.
void casters_draw(const Frame *frame, const Program *program);

// Was GL_DEPTH_CLAMP on when they were last drawn, or their volumes?
bool casters_were_clamped(void);

// Makes the volumes of light 0 on the CPU (silhouette.h) and draws them as GL_TRIANGLES with the program that
// draw_begin has made ready; its vertex shader is volume.vert.
void casters_draw_volumes(const Frame *frame);

// The same for the volume of object `i` alone. False for an open shape, which has none: nothing is drawn.
bool casters_draw_volume(const Frame *frame, int i);
