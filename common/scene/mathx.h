// Vectors and matrices: cglm's struct API, by value, right-handed, clip z in [-1, 1] as OpenGL has it.
// Matrices are named by what they map: clip_from_world * position_world = position_clip.
#pragma once

#ifndef CGLM_ALL_UNALIGNED
#define CGLM_ALL_UNALIGNED // structs with matrices cross a pipe: their layout must not depend on -m options
#endif
#include <cglm/struct.h>

#include <math.h>

static inline vec3s vec3_make(float x, float y, float z) {
    return (vec3s){{x, y, z}};
}
