// Shadow volumes whose sides are found on the CPU, as lab 07 draws them beside those of its geometry shader.
#pragma once

#include "casters.h"

// Makes the volumes of light 0 on the CPU (silhouette.h), between casters_create and casters_destroy, and
// draws them as GL_TRIANGLES with the program that draw_begin has made ready; its vertex shader is
// volume.vert. Sets u_world_from_object.
void casters_draw_volumes(const Frame *frame);

// The same for the volume of object `i` alone. False for an open shape, which has none: nothing is drawn.
bool casters_draw_volume(const Frame *frame, int i);
