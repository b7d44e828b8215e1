// Where the search for blockers may begin.
#pragma once

#include "lab.h"

// The distance along the light's axis, from the lamp on, at which the first caster can begin: no point of any
// object that is not a plane is nearer. At least the light's near plane.
static float nearest_caster(const Scene *scene) {
    const Light *light = &scene->lights[0];
#ifdef SOLUTION // 14.8
    vec3s axis = glms_vec3_normalize(glms_vec3_sub(light->target, light->position));
    float nearest = light->far_plane;
    for (int i = 0; i < scene->object_count; i++) {
        const Object *object = &scene->objects[i];
        if (object->shape == SHAPE_PLANE)
            continue;
        float reach = 0; // of a sphere around it: squared
        for (int column = 0; column < 3; column++)
            reach += glms_vec4_norm2(object->world_from_object.col[column]);
        vec3s middle = glms_vec3(object->world_from_object.col[3]);
        float along = glms_vec3_dot(glms_vec3_sub(middle, light->position), axis);
        nearest = fminf(nearest, along - sqrtf(reach));
    }
    return fmaxf(nearest, light->near_plane);
#else
    // TODO(14.8): each object lies within a sphere around its middle (column 3 of world_from_object), whose
    // radius squared is the sum of the squares of the columns 0 to 2. Find the least distance of these
    // spheres from the lamp, along the light's axis.
    return light->near_plane;
#endif
}
