// Ways to the same occlusion in less time, each an edit of this lab: the bake at -O2 with a sphere around
// each object that a ray must meet first, and the screen's at half size or projected by two factors.
#pragma once

#include "compile/rubric.h"

extern const Change occlusion_spheres, occlusion_half_size, occlusion_two_factors;
