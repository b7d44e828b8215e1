// Moving a scene's camera and lights about. Pure; what was not moved stays equal to the last bit, so that an
// untouched view is the graded picture.
#pragma once

#include "scene/scene.h"

// Relative to where the scene has put it.
typedef struct Orbit {
    float azimuth, elevation; // radians, about +y and upwards
    float zoom;               // natural logarithm of the distance's factor
    float right, up;          // the target's way, in distances to it
} Orbit;

// Keeps the eye off the poles (or where it began, if that is nearer) and at a sensible distance, for an eye
// that begins at `arm` from its target: what would lie beyond is forgotten, so that the way back begins at
// once.
void orbit_limit(Orbit *orbit, vec3s arm);

// Turns the eye about its target.
void orbit_camera(Camera *camera, const Orbit *orbit);

// The same for a light, whose distance to its target does not change.
void orbit_light(Light *light, const Orbit *orbit);

// The light's way at a time, in seconds: it swings to both sides of where it was, up to 40 degrees, once in 8
// s.
Orbit orbit_swing(const Orbit *orbit, double time);
