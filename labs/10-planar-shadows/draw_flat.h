// Given: drawing what flatten.h presses flat. And the names of knobs and programs.
#pragma once

#include "flatten.h"
#include "lab.h"

enum { KNOB_SHADOWS, KNOB_OPACITY, KNOB_LAMPS, KNOB_JITTER };
enum { SHADOWS_NONE, SHADOWS_NOON, SHADOWS_ANY };
enum { PROGRAM_MARK, PROGRAM_FLAT, PROGRAM_SHADE };

// What all shadows need: both faces of a caster, and the clip distance of flat.vert. Each fragment is
// `share`.
static void begin_flat(const Frame *frame, float share) {
    program_set_vec3(&frame->programs[PROGRAM_FLAT], "u_constant", vec3_make(share, share, share));
    glDisable(GL_CULL_FACE);
    glEnable(GL_CLIP_DISTANCE0);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

static void end_flat(void) {
    glDisable(GL_CLIP_DISTANCE0);
    glEnable(GL_CULL_FACE);
}

// Draws all other objects flat on receiver `i`, with the light at the place `lamp`.
static void draw_flat(const Frame *frame, int i, vec3s lamp) {
    const Program *program = &frame->programs[PROGRAM_FLAT];
    bool noon = frame->knobs[KNOB_SHADOWS] < SHADOWS_ANY;
    vec4s plane = receiver_plane(&frame->scene->objects[i]);
    vec4s light = light_point(&frame->scene->lights[0], lamp);
    program_set_mat4(program, "u_flat_from_world", noon ? flatten_noon(plane) : flatten(plane, light));
    program_set_vec4s(program, "u_plane", &plane, 1);
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    for (int j = 0; j < frame->scene->object_count; j++)
        if (j != i)
            draw_object(frame, program, j);
}
