// Given: a texture with a layer for each caster.
#pragma once

#include "caster_volumes.h"
#include "lab.h"
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

// For so many casters at most. One more is there, so that it is a texture also for none.
static bool layers_create(Layers *layers, int width, int height, int most) {
    *layers = (Layers){.width = width, .height = height};
    glGenTextures(1, &layers->texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, layers->texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RG32F, width, height, most + 1, 0, GL_RG, GL_FLOAT, NULL);
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
