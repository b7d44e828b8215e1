// For tests that hold a solution's picture against a closed form.
#pragma once

#include "exam/exam.h"
#include "truth/closed_scenes.h"

// Lets the solution of lab `id` draw its picture of `scene`. Fails the test unless it says why it cannot,
// with these words in its message.
void witness_refuses(const char *id, const Scene *scene, const char *words);

// Draws `scene` with the solution of lab `id`: `view` is "picture", "visibility" or a stage. Knobs: pairs of
// a name and a value, NULL for none. Fails the test when nothing is drawn. The caller destroys the image.
typedef struct WitnessKnob {
    const char *name;
    float value;
} WitnessKnob;
Image witness_draw(const char *id, const Scene *scene, const char *view, int width, int height,
                   const WitnessKnob *knobs, int knob_count);

// A square plate in a plane z = center.z, thin enough to cut segments by hand.
typedef struct WitnessPlate {
    vec3s center;
    float half;
} WitnessPlate;

// Does one of the plates, made larger by `margin`, cut the segment from the point to the end?
bool witness_cuts(const WitnessPlate *plates, int count, vec3s point, vec3s end, float margin);
