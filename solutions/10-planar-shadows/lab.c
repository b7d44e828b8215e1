// Lab 10: planar shadows. Press each caster flat onto each plane, and take the light away where it falls.
#include "draw_flat.h"
#include "lab.h"

enum { ONCE = 0x80 }; // a bit of the stencil beside the receiver's number

static struct {
    Target taken;     // for each pixel the share of the light that is taken; with depth and stencil
    Target projected; // for the stage "projected"
} state;

static bool create(const Frame *frame) {
    GLenum format = GL_R8;
#ifdef SOLUTION // 10.10
    format = GL_R32F;
#else
    // TODO(10.10): 8 bits round each of the n * n small shares to 1/255, and half floats round the sum. Take
    // one channel of 32-bit floats.
#endif
    return target_create(&state.taken, frame->width, frame->height, format, GL_DEPTH24_STENCIL8) &&
           target_create(&state.projected, frame->width, frame->height, GL_RGBA8, 0);
}

static void destroy(void) {
    target_destroy(&state.taken);
    target_destroy(&state.projected);
}

// Pass 1: the depth of all that is seen, and in the stencil which receiver is seen: its number, from 1 on.
static void mark_receivers(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_MARK];
    target_bind(&state.taken);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    for (int i = 0; i < frame->scene->object_count; i++) {
        bool receives = frame->scene->objects[i].shape == SHAPE_PLANE;
#ifdef SOLUTION // 10.7
        glStencilFunc(GL_ALWAYS, receives ? i + 1 : 0, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
#else
        // TODO(10.7): where this object is seen, write i + 1 into the stencil, or 0 when it does not receive.
        // Look up: glStencilFunc, glStencilOp.
        UNUSED(receives);
#endif
        draw_object(frame, program, i);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// The shadows that one small lamp throws onto all receivers; each takes `share` of the light.
static void take_light(const Frame *frame, vec3s lamp, float share) {
    begin_flat(frame, share);
    glStencilMask(ONCE);
    glClear(GL_STENCIL_BUFFER_BIT); // this bit only
    for (int i = 0; i < frame->scene->object_count; i++) {
        if (frame->scene->objects[i].shape != SHAPE_PLANE) {
            continue;
        }
#ifdef SOLUTION // 10.7
        glStencilFunc(GL_EQUAL, i + 1, 0xff);
#else
        // TODO(10.7), second part: let the shadow through only where receiver i is seen.
#endif
#ifdef SOLUTION // 10.8
        glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
#else
        // TODO(10.8): two casters, or front and back of one, must not take the light twice. Only the bit ONCE
        // can be written: change it where a shadow is drawn, and the number fits no more. Look up: GL_INVERT.
#endif
        draw_flat(frame, i, lamp);
    }
    glStencilMask(0xff);
    end_flat();
}

// Pass 2: sum what all small lamps lose.
static void draw_shadows(const Frame *frame) {
    const Light *light = &frame->scene->lights[0];
    int n = light->extent > 0 ? (int)frame->knobs[KNOB_LAMPS] : 1;
    float share = 1 / (float)(n * n);
#ifdef SOLUTION // 10.8
    share *= frame->knobs[KNOB_OPACITY];
#else
    // TODO(10.8), second part: glass takes only a part of the light: frame->knobs[KNOB_OPACITY].
#endif
    target_bind(&state.taken);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthMask(GL_FALSE);
#ifdef SOLUTION // 10.6
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -16);
#else
    // TODO(10.6): a shadow has the depth of its receiver, and rounding decides which of them is in front.
    // Pull the shadow a little towards the camera: once its slope and a few units; which sign is nearer?
    // Look up: glPolygonOffset, GL_POLYGON_OFFSET_FILL.
#endif
    for (int k = 0; k < n * n && frame->knobs[KNOB_SHADOWS] > SHADOWS_NONE; k++)
        take_light(frame, lamp_position(light, n, k % n, k / n, frame->knobs[KNOB_JITTER]), share);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
}

// Pass 3: the picture.
static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADE];
    frame_bind(frame);
    program_set_texture(program, "u_taken", 0, GL_TEXTURE_2D, state.taken.color);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

// Given, for the stage "projected": the flattened casters alone, in front of everything and past every edge.
static void show_projected(const Frame *frame) {
    target_bind(&state.projected);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    begin_flat(frame, 1);
    for (int i = 0; i < frame->scene->object_count; i++)
        if (frame->scene->objects[i].shape == SHAPE_PLANE)
            draw_flat(frame, i, frame->scene->lights[0].position);
    end_flat();
    glEnable(GL_DEPTH_TEST);
}

const Lab lab = {
    .title = "Planar shadows",
    .programs = {[PROGRAM_MARK] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_FLAT] = {"flat.vert", "constant.frag", NULL},
                 [PROGRAM_SHADE] = {"scene.vert", "shade.frag", NULL}},
    .knobs = {[KNOB_SHADOWS] = {"shadows", "", 0, 2, 2, {"none", "noon", "any light"}},
              [KNOB_OPACITY] = {"opacity", "", 0, 1, 1},
              [KNOB_LAMPS] = {"lamps", "along a side", 1, 16, 4},
              [KNOB_JITTER] = {"jitter", "cells", 0, 1, 1}},
    .passes = {{"receivers", mark_receivers, PASS_PREPARE},
               {"shadows", draw_shadows, PASS_PREPARE},
               {"picture", draw_picture},
               {"projected", show_projected, PASS_SHOW}},
    .stages = {{"taken", &state.taken.color}, {"projected", &state.projected.color}},
    .create = create,
    .destroy = destroy,
};
