// Given: a texture with a layer for each caster, and what the programs of this lab are told.
#pragma once

#include "casters.h"
#include "lab.h"
#include "shadow_map.h"
#include "target.h"

enum { LAYERS = 8 }; // closed objects that a scene may have here

typedef struct Layers {
    GLuint framebuffer;
    GLuint texture; // GL_TEXTURE_2D_ARRAY, two floats: enters, leaves
    int width, height;
    int count; // layers that hold a caster, in the order of the scene
} Layers;

static void layers_attach(const Layers *layers, int layer) {
    glBindFramebuffer(GL_FRAMEBUFFER, layers->framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, layers->texture, 0, layer);
}

static bool layers_create(Layers *layers, int width, int height) {
    *layers = (Layers){.width = width, .height = height};
    glGenTextures(1, &layers->texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, layers->texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RG32F, width, height, LAYERS, 0, GL_RG, GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glGenFramebuffers(1, &layers->framebuffer);
    layers_attach(layers, 0);
    return gl_check_framebuffer("layers");
}

static void layers_destroy(Layers *layers) {
    glDeleteFramebuffers(1, &layers->framebuffer);
    glDeleteTextures(1, &layers->texture);
    *layers = (Layers){0};
}

// Draws the volume of each closed object into a cleared layer of its own, with the program in use.
static void layers_draw(Layers *layers, const Frame *frame) {
    layers->count = 0;
    glViewport(0, 0, layers->width, layers->height);
    for (int i = 0; i < frame->scene->object_count; i++) {
        if (frame->scene->objects[i].shape == SHAPE_PLANE)
            continue;
        if (layers->count == LAYERS) {
            check_fail("lab 13 takes %d boxes and spheres at most; this scene has more", LAYERS);
            return;
        }
        layers_attach(layers, layers->count);
        glClearBufferfv(GL_COLOR, 0, (float[]){0, 0, 0, 0});
        layers->count += casters_draw_volume(frame, i);
    }
}

static void layers_bind(const Layers *layers, const Program *program) {
    program_set_texture(program, "u_intervals", 1, GL_TEXTURE_2D_ARRAY, layers->texture);
    program_set_int(program, "u_count", layers->count);
}

// Copies the first layer to a picture; black when there is none.
static void layers_show(const Layers *layers, const Target *picture) {
    target_bind(picture);
    glClearBufferfv(GL_COLOR, 0, (float[]){0, 0, 0, 1});
    if (layers->count == 0)
        return;
    layers_attach(layers, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture->framebuffer);
    glBlitFramebuffer(0, 0, layers->width, layers->height, 0, 0, layers->width, layers->height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

// A target of one float a pixel, which is seen as grey.
static bool grey_create(Target *target, int width, int height) {
    const GLint grey[] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    if (!target_create(target, width, height, GL_R32F, 0))
        return false;
    glBindTexture(GL_TEXTURE_2D, target->color);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, grey);
    return true;
}

// What dust.glsl asks for.
static void set_air(const Frame *frame, const Program *program, GLuint depth) {
    program_set_float(program, "u_scattering", frame->scene->medium.scattering);
    program_set_float(program, "u_extinction", frame->scene->medium.extinction);
    program_set_mat4(program, "u_world_from_clip", glms_mat4_inv(frame_clip_from_world(frame)));
    program_set_texture(program, "u_depth", 0, GL_TEXTURE_2D, depth);
}

// The shadow map of light 0.
static void set_map(const Frame *frame, const Program *program, GLuint map) {
    program_set_mat4(program, "u_light_clip_from_world",
                     shadow_map_clip_from_world(&frame->scene->lights[0]));
    program_set_texture(program, "u_shadow_map", 1, GL_TEXTURE_2D, map);
}

// One triangle over the whole picture; the program is told the eye and the lights.
static void draw_over_all(const Frame *frame, const Program *program) {
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    draw_fullscreen(program);
}
