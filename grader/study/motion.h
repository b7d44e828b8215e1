// A light that turns and a camera that moves: what a method changes from frame to frame beyond what changes
// in truth.
#pragma once

#include "study/study_scene.h"

enum { MOTION_FRAMES = 5 }; // of each kind; the first is the view itself

typedef enum MotionKind { MOTION_LIGHT, MOTION_CAMERA, MOTION_KINDS } MotionKind;

// Arrays of size.width * size.height, owned.
typedef struct MotionFrame {
    Scene scene;
    float *truth;    // at the pixels' centres
    uint8_t *counts; // 1 where a method's pixel counts
} MotionFrame;

typedef struct Motion {
    MetricsSize size;
    MotionFrame frames[MOTION_KINDS][MOTION_FRAMES];
} Motion;

// From `from`, a view of the scene, the lights or the camera go around their targets, by .3 to .6 degrees a
// frame, so that no step of a map's grid is like another. Traces all frames; `artist` draws the triangles.
// False with a message; the caller destroys the motion in any case.
bool motion_create(Motion *motion, const StudyScene *scene, const Scene *from, MetricsSize size,
                   LabArtist *artist);
void motion_destroy(Motion *motion); // accepts a zeroed motion

// Draws all frames of both kinds. Each kind gets the mean over the pixels and the steps of how much a pixel
// changes, less how much it changes in truth: 0 for edges that go where the true ones go, however soft; more
// where they crawl or flicker; less where something that moves is missing. False with a message.
bool motion_measure(const Motion *motion, LabArtist *artist, const Setting *setting,
                    double beyond[MOTION_KINDS]);

// The sum of what changes between two frames of a method less what changes in truth, over the pixels that
// count in both, whose number is added to `count`.
double motion_changes(MetricsSize size, const float *const shown[2], const MotionFrame frames[2],
                      double *count);
