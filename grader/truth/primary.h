// The rays through the pixels of a picture.
#pragma once

#include "scene/scene.h"

// The direction through a point of the picture is forward + x * right + y * up, x and y in -1..1: one unit of
// depth long, so that a ray's length is the depth that GL clips at.
typedef struct PrimaryRays {
    int width, height;
    vec3s right, up, forward;
} PrimaryRays;

// For a picture of this size.
PrimaryRays primary_rays(const Camera *camera, int width, int height);

// Through a place in a pixel, 0..1 from its left upper corner; row 0 is the top row.
vec3s primary_direction(const PrimaryRays *primary, int column, int row, vec2s within);
