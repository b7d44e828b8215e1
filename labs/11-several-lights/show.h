// Given: what the stages show, and the uniforms of maps.glsl.
#pragma once

#include "cube.h"
#include "lab.h"
#include "maps.h"
#include "target.h"

enum { TILES = 2, FACES_ACROSS = 3 };

typedef struct Shown {
    Target maps;  // the first four maps: 0 and 1 below, 2 and 3 above
    Target cube;  // the faces of the scene's first LIGHT_POINT: 0 to 2 below, 3 to 5 above
    Target asked; // how many maps a point asked: black 0, white 8 and more; half as large as the picture
} Shown;

static bool shown_create(Shown *shown, const Frame *frame, int size) {
    return target_create(&shown->maps, TILES * size, TILES * size, 0, GL_DEPTH_COMPONENT24) &&
           target_create(&shown->cube, FACES_ACROSS * size, 2 * size, 0, GL_DEPTH_COMPONENT24) &&
           target_create(&shown->asked, (frame->width + 1) / 2, (frame->height + 1) / 2, GL_RGBA8,
                         GL_DEPTH_COMPONENT24);
}

static void shown_destroy(Shown *shown) {
    target_destroy(&shown->maps);
    target_destroy(&shown->cube);
    target_destroy(&shown->asked);
}

static void clear_depth(const Target *target) {
    target_bind(target);
    glClear(GL_DEPTH_BUFFER_BIT);
}

// Copies a layer of a depth texture to a tile of the target, by way of a framebuffer.
static void copy_layer(const Target *target, int column, int row, GLuint framebuffer, GLuint texture,
                       int layer, int size) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, layer);
    glBindTexture(GL_TEXTURE_2D, target->depth);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, column * size, row * size, 0, 0, size, size);
}

static void show_maps(const Shown *shown, GLuint framebuffer, GLuint maps, int count) {
    clear_depth(&shown->maps);
    for (int k = 0; k < TILES * TILES && k < count && maps; k++)
        copy_layer(&shown->maps, k % TILES, k / TILES, framebuffer, maps, k, shown->maps.width / TILES);
}

static void show_cube(const Shown *shown, GLuint framebuffer, GLuint cubes, const Scene *scene) {
    int lamp = 0;
    clear_depth(&shown->cube);
    while (lamp < scene->light_count && scene->lights[lamp].kind != LIGHT_POINT)
        lamp++;
    for (int face = 0; face < CUBE_FACES && lamp < scene->light_count; face++)
        copy_layer(&shown->cube, face % FACES_ACROSS, face / FACES_ACROSS, framebuffer, cubes,
                   CUBE_FACES * lamp + face, shown->cube.height / 2);
}

// True when the stage is looked at.
static bool show_asked_begin(const Shown *shown, const Frame *frame) {
    target_bind(&shown->asked);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return frame_shows(frame, "asked");
}

static void set_map_uniforms(const Program *program, const MapList *list) {
    char name[64];
    for (int k = 0; k < list->count; k++) {
        snprintf(name, sizeof name, "u_map_clip_from_world[%d]", k);
        program_set_mat4(program, name, shadow_map_clip_from_world(&list->lights[k]));
    }
    program_set_vec4s(program, "u_maps_of_light", list->of_light, SCENE_MAX_LIGHTS);
}
