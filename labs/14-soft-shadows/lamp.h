// Where the search for blockers may begin.
#pragma once

#include "lab.h"

// The distance along the light's axis, from the lamp on, at which the first caster can begin: no point of any
// object that is not a plane is nearer. At least the light's near plane.
static float nearest_caster(const Scene *scene) {
    const Light *light = &scene->lights[0];
    // TODO(14.8): each object lies within a sphere around its middle (column 3 of world_from_object), whose
    // radius squared is the sum of the squares of the columns 0 to 2. Find the least distance of these
    // spheres from the lamp, along the light's axis.
    return light->near_plane;
}
