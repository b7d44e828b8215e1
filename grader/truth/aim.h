// Where the rays of a query go: one Aim a ray, shared by the pixels of a tile.
#pragma once

#include "truth/truth.h"

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

// Two unit vectors at right angles to the unit vector n and to each other (Duff et al.: Building an
// Orthonormal Basis, Revisited, JCGT 2017).
void aim_frame(vec3s n, vec3s *tangent, vec3s *bitangent);

// Where the rays of a point begin. A ray that begins on a triangle must not meet it, but must meet what
// stands on it. Positions are good to a few units in the last place of their largest coordinate; 2^-19 of
// that is 16 of them.
vec3s aim_origin(const TruthHit *hit);

// Writes the aims of a tile and returns their number, at most TRUTH_MAX_SAMPLES. The samples fill an across x
// down grid of strata, as square as the number allows, one jittered sample in each (Cook: Stochastic Sampling
// in Computer Graphics, TOG 1986); directions follow the cosine by Malley's method (a disc's samples raised
// to the hemisphere).
int aim_all(const Scene *scene, const TruthQuery *query, int tile, Aim *aims);
