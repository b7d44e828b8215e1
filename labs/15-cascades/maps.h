// Given: an array of depth maps, and drawing into its layers (lab 11).
#pragma once

#include "lab.h"

#include <stdio.h>

typedef struct Maps {
    GLuint framebuffer, texture; // GL_TEXTURE_2D_ARRAY, a layer for each slice
    int size;                    // texels along a side
} Maps;

static bool maps_create(Maps *maps, int size, int layers) {
    maps->size = size;
    glGenTextures(1, &maps->texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps->texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, size, size, layers, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glGenFramebuffers(1, &maps->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, maps->framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps->texture, 0, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return gl_check_framebuffer("maps");
}

static void maps_destroy(Maps *maps) {
    glDeleteFramebuffers(1, &maps->framebuffer);
    glDeleteTextures(1, &maps->texture);
    *maps = (Maps){0};
}

// What all layers need. Where the shader moves points along their normals, nothing is added to the depths.
static void maps_begin(const Maps *maps, bool normal_offset) {
    glBindFramebuffer(GL_FRAMEBUFFER, maps->framebuffer);
    glViewport(0, 0, maps->size, maps->size);
    if (!normal_offset)
        glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
}

// From now on, what is drawn goes to this layer, which is cleared.
static void maps_begin_layer(const Maps *maps, int layer) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps->texture, 0, layer);
    glClear(GL_DEPTH_BUFFER_BIT);
}

static void maps_end(void) {
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
}

// The matrix of a layer, for cascades.glsl.
static void maps_set_matrix(const Program *program, int layer, mat4s clip_from_world) {
    char name[64];
    snprintf(name, sizeof name, "u_map_clip_from_world[%d]", layer);
    program_set_mat4(program, name, clip_from_world);
}
