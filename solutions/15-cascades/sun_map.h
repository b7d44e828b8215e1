// The sun's map of a slice: where it looks, and what it holds.
#pragma once

#include "lab.h"
#include "slices.h"

// Given: turned as the sun is, around the world's origin. The sun looks along -z there, whatever the camera
// does.
static mat4s sun_from_world(const Light *light) {
    mat4s view = light_is_overhead(light) ? light_view_from_overhead(light)
                                          : glms_lookat(light->position, light->target, vec3_make(0, 1, 0));
    view.col[3] = (vec4s){{0, 0, 0, 1}};
    return view;
}

// Moves the middle of a map, which is given and returned in sun space, by less than a texel to the side.
static vec3s snap(vec3s middle_sun, float texel) {
#ifdef SOLUTION // 15.7
    middle_sun.x = roundf(middle_sun.x / texel) * texel;
    middle_sun.y = roundf(middle_sun.y / texel) * texel;
#else
    // TODO(15.7): let the map move by whole texels only: x and y must be multiples of `texel`. Look up:
    // roundf.
    UNUSED(texel);
#endif
    return middle_sun;
}

// From sun space to the map's clip space: a map around middle_sun, `half` to each side, that holds all depths
// from `radius` before the middle to `radius` behind it.
static mat4s clip_from_sun(vec3s middle_sun, float half, float radius) {
#ifdef SOLUTION // 15.3
    return glms_ortho(middle_sun.x - half, middle_sun.x + half, middle_sun.y - half, middle_sun.y + half,
                      -middle_sun.z - radius, -middle_sun.z + radius);
#else
    // TODO(15.3): an orthographic projection. Its planes are distances along -z: what is nearer to the sun
    // has the larger z. Look up: glms_ortho.
    UNUSED(middle_sun, half, radius);
    return glms_mat4_identity();
#endif
}

// Given: all that is known of slice i, whose map has size x size texels.
static Slice find_slice(const Frame *frame, int size, int i) {
    const Camera *camera = &frame->scene->camera;
    int count = (int)frame->knobs[KNOB_SLICES];
    Slice slice = {.begin = slice_begin(frame, i, count),
                   .end = border(camera, frame->knobs[KNOB_LAMBDA], i + 1, count)};
    find_sphere(&slice, corner_tangent(camera, (float)frame->width / (float)frame->height));
    // One texel more to each side, so that the map may be moved.
    float half = slice.radius * (float)size / (float)(size - 2);
    slice.texel = 2 * half / (float)size;
    mat4s turned = sun_from_world(&frame->scene->lights[0]);
    vec3s axis = camera_axis(camera);
    vec3s middle = glms_mat4_mulv3(turned, glms_vec3_muladds(axis, slice.centre, camera->eye), 1);
    if (frame->knobs[KNOB_SNAP] > 0)
        middle = snap(middle, slice.texel);
    slice.clip_from_world = glms_mat4_mul(clip_from_sun(middle, half, slice.radius), turned);
    return slice;
}
