// The slices of what the camera sees, and the sun's map of each.
#pragma once

#include "lab.h"

enum { KNOB_SLICES, KNOB_LAMBDA, KNOB_MAP_SIZE, KNOB_SNAP, KNOB_BIAS, KNOB_OFFSET, KNOB_BLEND };
enum { PROGRAM_DEPTH, PROGRAM_SHADE, PROGRAM_SHOW };
enum { MOST_SLICES = 4 };

// All distances are measured before the eye, along the camera's axis.
typedef struct Slice {
    float begin, end;
    float centre, radius; // a sphere around the slice; its centre lies on the camera's axis
    float texel;          // side of a texel of its map, world units
    mat4s clip_from_world;
} Slice;

// Given: the unit vector along which the camera looks.
static vec3s camera_axis(const Camera *camera) {
    return glms_vec3_normalize(glms_vec3_sub(camera->target, camera->eye));
}

// Where slice i - 1 ends and slice i begins, of `count` slices: border 0 is the camera's near plane, border
// `count` its far plane. `lambda`: 1 is logarithmic, 0 is uniform.
static float border(const Camera *camera, float lambda, int i, int count) {
#ifdef SOLUTION // 15.1
    float n = camera->near_plane, f = camera->far_plane, share = (float)i / (float)count;
    return lambda * n * powf(f / n, share) + (1 - lambda) * (n + (f - n) * share);
#else
    // TODO(15.1): the first slice reaches to the far plane, and nothing is left for the others. Blend the
    // logarithmic and the uniform border, see the handout. Look up: powf.
    UNUSED(lambda, count);
    return i == 0 ? camera->near_plane : camera->far_plane;
#endif
}

// Where slice i begins: from there on the slice before it is blended into it.
static float slice_begin(const Frame *frame, int i, int count) {
    const Camera *camera = &frame->scene->camera;
    float lambda = frame->knobs[KNOB_LAMBDA], blend = frame->knobs[KNOB_BLEND];
    float begin = border(camera, lambda, i, count);
#ifdef SOLUTION // 15.9
    if (i > 0)
        begin -= blend * (begin - border(camera, lambda, i - 1, count));
#else
    // TODO(15.9): the last part of slice i - 1 is blended into slice i: so much of its length must be in
    // the map of slice i, too. `blend` is that part.
    UNUSED(blend);
#endif
    return begin;
}

// How far from the axis a corner of the picture is, for each unit before the eye. aspect = width / height.
static float corner_tangent(const Camera *camera, float aspect) {
#ifdef SOLUTION // 15.2
    return tanf(camera->fov_y / 2) * sqrtf(1 + aspect * aspect);
#else
    // TODO(15.2): this is the middle of the upper edge. A corner is farther away: aspect times as far to the
    // side as upwards.
    UNUSED(aspect);
    return tanf(camera->fov_y / 2);
#endif
}

// The smallest sphere that holds the slice's eight corners, k = corner_tangent; from a to b, in the handout's
// words.
static void find_sphere(Slice *slice, float k) {
    float a = slice->begin, b = slice->end;
#ifdef SOLUTION // 15.2
    slice->centre = fminf((a + b) * (1 + k * k) / 2, b);
    slice->radius = hypotf(b - slice->centre, b * k);
#else
    // TODO(15.2), second part: this sphere has the slice's length and leaves its corners out. See the
    // handout.
    UNUSED(k);
    slice->centre = (a + b) / 2;
    slice->radius = (b - a) / 2;
#endif
}
