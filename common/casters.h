// Drawing what casts shadow volumes: the scene's closed objects, each triangle with its
// neighbours (adjacency.h). An open mesh, like the floor, has no inside and so no volume: it
// receives shadows and casts none.
#pragma once

#include "draw.h"
#include "scene/adjacency.h"

#include <stdbool.h>

// Makes the meshes on the GPU; a lab calls both in its create and destroy, before and after it draws casters.
// False with a message when there is no memory; casters_destroy accepts what was not made, or only in part.
bool casters_create(void);
void casters_destroy(void);

// Draws the closed objects as GL_TRIANGLES_ADJACENCY with the program that draw_begin has made ready; sets
// u_world_from_object. The vertices are those of model.h.
void casters_draw(const Frame *frame, const Program *program);

// A shape's mesh and its triangles with their neighbours, of all shapes, open ones too; valid until
// casters_destroy.
const Mesh *casters_mesh(Shape shape);
const Adjacency *casters_adjacency(Shape shape);

// Was GL_DEPTH_CLAMP on when they were last drawn, or their volumes? Who draws volumes notes it.
bool casters_were_clamped(void);
void casters_note_clamp(void);
