// Where the rays of a query go: one Aim a ray, shared by the pixels of a tile.
#pragma once

#include "truth.h"

typedef enum AimKind {
    AIM_POINT,     // at the point `value`, as far as it
    AIM_DIRECTION, // along `value`, for ever
    AIM_LOCAL      // along `value` in the frame (tangent, bitangent, face normal) of each pixel
} AimKind;

typedef struct Aim {
    AimKind kind;
    vec3s value;
    vec3s front; // AIM_POINT: what lies behind the point as seen along `front` is dark; zero: nothing does
    float limit; // length of the ray, in lengths of `value` (AIM_POINT: of the way to it)
} Aim;

// Writes the aims of a tile and returns their number, at most TRUTH_MAX_SAMPLES. The samples fill an across x
// down grid of strata, as square as the number allows, one jittered sample in each (Cook: Stochastic Sampling
// in Computer Graphics, TOG 1986); directions follow the cosine by Malley's method (a disc's samples raised
// to the hemisphere).
int aim_all(const Scene *scene, const TruthQuery *query, int tile, Aim *aims);
