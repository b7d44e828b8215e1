// What varies from one exam to the next, drawn from its seed: the size of a check's frames, and for each
// variant the scene with its camera and lights, and the knobs.
#pragma once

#include "compile/rubric.h"
#include "protocol/protocol.h"
#include "scene/random.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct Draw {
    Random random;
    int width, height; // of all frames of the check
    int start;         // where the lists of choices begin
} Draw;

// For check c of the exam. Frames hold 14,000 to 30,000 pixels, are from 3:4 upright to 2:1 across, and
// neither side is a multiple of 8; those of a check with a "large frame" are larger than 640 x 480, for labs
// whose resources must have the frame's size.
Draw draw_begin_check(const Rubric *rubric, uint64_t seed, int c);

// The scene of variant n, a name of the check's.
const char *draw_scene_name(const Draw *draw, const Check *check, int n);

// The next try for variant n of the check. The same sequence of calls gives the same requests. False with a
// message for an unknown scene.
bool draw_request(Draw *draw, Request *request, const Check *check, int n);
