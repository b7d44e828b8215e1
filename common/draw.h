// Drawing a frame's scene with a program of the lab.
#pragma once

#include "gl.h"
#include "mathx.h"
#include "program.h"
#include "scene.h"

#include <stdbool.h>

// What a pass is given. The picture goes to `framebuffer`, which has colour, 24 bits of depth and 8 of stencil; it is
// cleared and bound, with the viewport on all of it, when the first pass begins.
typedef struct Frame {
    const Scene *scene;
    const Program *programs; // in the order of the lab's table
    const float *knobs;      // current values, in the order of the lab's table
    GLuint framebuffer;
    int width, height;
    bool flat_light; // the visibility view: see shaders/lighting.glsl
} Frame;

// Makes the meshes on the GPU; called once by the worker.
bool draw_create(void);
void draw_destroy(void);

// Binds the frame's framebuffer, with the viewport on all of it.
void draw_to_frame(const Frame *frame);

// The matrix of the frame's camera, for a picture of the frame's size.
mat4s draw_clip_from_world(const Frame *frame);

// Draws all objects. Sets, where the program has them: u_clip_from_world, the uniforms of shaders/scene.vert and
// shaders/lighting.glsl (with `eye` as the place of the viewer, for highlights) and u_is_screen. Other uniforms keep
// what the lab gave them.
void draw_scene(const Frame *frame, const Program *program, mat4s clip_from_world, vec3s eye);

// Draws one triangle that covers the viewport; for shaders/fullscreen.vert, which passes v_uv on. The caller turns the
// depth test off where it is not wanted.
void draw_fullscreen(const Program *program);
