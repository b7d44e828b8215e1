// The lines that show what a light's map sees. Pure.
#pragma once

#include "scene/scene.h"

enum { GUIDE_MOST_ENDS = 80 };

typedef struct GuideLines {
    vec3s ends[GUIDE_MOST_ENDS]; // two a line, world
    int count;
} GuideLines;

// Adds the edges of the volume that the map of a spot light or a sun sees; of a point light, which has six
// maps, the lines where they meet. Then a cross where the light is, and the sides of a lamp that has a size.
void guide_lines_add(GuideLines *lines, const Light *light);
