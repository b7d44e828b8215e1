// For tests that ask the ray-traced truth about points of their own, without a camera.
#pragma once

#include "truth/truth.h"

// Mean visibility of one point, from `tiles` tiles of samples: so of tiles * query->samples stratified rays.
// Fails the test when nothing is traced.
double truth_point(const Scene *scene, vec3s position, vec3s normal, const TruthQuery *query, int tiles);

// Adds an object with any matrix.
void truth_point_add(Scene *scene, Shape shape, mat4s world_from_object);

// Four standard errors of a share near `share` from `samples` independent rays; stratified ones spread less.
double truth_point_noise(double share, double samples);
