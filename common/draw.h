// Drawing a frame's scene with a program of the lab.
#pragma once

#include "gl.h"
#include "scene/mathx.h"
#include "program.h"
#include "scene/scene.h"

#include <stdbool.h>

// What a pass is given. The picture goes to `framebuffer`, which has colour, 24 bits of depth and 8 of
// stencil; it is cleared and bound, with the viewport on all of it, when the first pass begins.
typedef struct Frame {
    const Scene *scene;
    const Program *programs; // in the order of the lab's table
    const float *knobs;      // current values, in the order of the lab's table
    GLuint framebuffer;
    int width, height;
    bool flat_light;  // the visibility view: see shaders/lighting.glsl
    const char *view; // "picture", "visibility" or the name of the stage that is looked at
} Frame;

// Makes the meshes on the GPU; called once by the worker.
bool draw_create(void);
void draw_destroy(void);

// Is this stage looked at? Others need not be drawn.
bool frame_shows(const Frame *frame, const char *stage);

// Binds the frame's framebuffer, with the viewport on all of it.
void frame_bind(const Frame *frame);

// The matrix of the frame's camera, for a picture of the frame's size.
mat4s frame_clip_from_world(const Frame *frame);

// Draws all objects: draw_begin and draw_objects.
void draw_scene(const Frame *frame, const Program *program, mat4s clip_from_world, vec3s eye);

// Uses the program and sets, where it has them: u_clip_from_world and the uniforms of
// shaders/lights.glsl that belong to the frame, with `eye` as the place of the viewer (for highlights).
// Others keep what the lab gave them.
void draw_begin(const Frame *frame, const Program *program, mat4s clip_from_world, vec3s eye);

// Draws all objects with the program in use; sets what belongs to an object: u_world_from_object, u_color,
// u_specular, u_shininess, u_is_screen, u_object (its number).
void draw_objects(const Frame *frame, const Program *program);

// The same for object `i` of the scene alone.
void draw_object(const Frame *frame, const Program *program, int i);

// Draws one triangle that covers the viewport; for shaders/fullscreen.vert, which passes v_uv on. The caller
// turns the depth test off where it is not wanted.
void draw_fullscreen(const Program *program);
