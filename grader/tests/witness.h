// For tests that hold a solution's picture against a closed form.
#pragma once

#include "exam.h"

// Draws `scene` with the solution of lab `id`: `view` is "picture", "visibility" or a stage. Knobs: pairs of
// a name and a value, NULL for none. Fails the test when nothing is drawn. The caller destroys the image.
typedef struct WitnessKnob {
    const char *name;
    float value;
} WitnessKnob;
Image witness_draw(const char *id, const Scene *scene, const char *view, int width, int height,
                   const WitnessKnob *knobs, int knob_count);

// A white wall in the plane z = 0 that faces +z, half_size wide, seen straight on from (0, 0, distance) so
// that one world unit of the wall covers the same number of pixels everywhere. No light yet.
Scene witness_wall(float half_size, float distance, float fov_y);

// World units of the wall per pixel of a picture `height` pixels high.
double witness_unit(const Scene *scene, int height);

// Adds an object; `turn` in degrees about +y.
void witness_add(Scene *scene, Shape shape, vec3s center, vec3s half_size, float turn);
void witness_light(Scene *scene, LightKind kind, vec3s position, vec3s target, float fov_y, float half_size,
                   float near_plane, float far_plane);
