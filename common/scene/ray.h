// Rays against a scene, exactly (a sphere is a sphere here, not its mesh). No GL.
#pragma once

#include "scene/scene.h"

#include <stdbool.h>

// How far above a surface, in world units, a ray from it starts: more than rounding errors,
// less than a gap that shows.
#define RAY_OFFSET 1e-3f

// Does the ray meet a surface at a distance above 0 and up to max_distance? `direction` has length 1. Planes
// are hit from both sides, boxes and spheres also from inside. A ray that starts on a surface may hit just
// that one: rounding decides.
bool ray_hits(const Scene *scene, vec3s origin, vec3s direction, float max_distance);
