// Given: the passes before and after the dust, and what the programs of this lab are told.
#pragma once

#include "lab.h"
#include "shadow_map.h"
#include "target.h"

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

static void set_map(const Frame *frame, const Program *program, const ShadowMap *map) {
    mat4s light_clip_from_world = shadow_map_clip_from_world(&frame->scene->lights[0]);
    program_set_mat4(program, "u_light_clip_from_world", light_clip_from_world);
    program_set_texture(program, "u_shadow_map", 1, GL_TEXTURE_2D, map->texture);
}

// One triangle over the whole picture; the program is told the eye and the lights.
static void draw_over_all(const Frame *frame, const Program *program) {
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    draw_fullscreen(program);
}

// Does this lab know what is in the scene? False with a message.
static bool air_check(const Scene *scene) {
    if (scene->lights[0].kind == LIGHT_POINT)
        return check_fail("lab 13 knows spot lights and suns; this scene has a point light");
    for (int i = 0; i < scene->object_count; i++)
        if (glms_mat4_det(scene->objects[i].world_from_object) <= 0)
            return check_fail("object %d of the scene is mirrored or flat: its shadow volume has no inside",
                              i);
    return true;
}

static void air_draw_map(const Frame *frame, const Program *program, const ShadowMap *map) {
    const Light *light = &frame->scene->lights[0];
    air_check(frame->scene);
    shadow_map_begin(map);
    draw_scene(frame, program, shadow_map_clip_from_world(light), light->position);
}

static void air_draw_surfaces(const Frame *frame, const Program *program, const Target *surfaces,
                              const ShadowMap *map) {
    vec3s sky = frame->scene->background;
    target_bind(surfaces);
    glClearColor(sky.x, sky.y, sky.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_map(frame, program, map);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

static void air_begin_dust(const Target *dust) {
    target_bind(dust);
    glDisable(GL_DEPTH_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void air_draw_picture(const Frame *frame, const Program *program, const Target *surfaces,
                             const Target *dust) {
    glDisable(GL_DEPTH_TEST);
    set_air(frame, program, surfaces->depth);
    program_set_int(program, "u_shows_distance", false);
    program_set_texture(program, "u_surfaces", 1, GL_TEXTURE_2D, surfaces->color);
    program_set_texture(program, "u_dust", 2, GL_TEXTURE_2D, dust->color);
    draw_over_all(frame, program);
}

// For the stage "distance": 20 units are white.
static void air_show_distance(const Frame *frame, const Program *program, const Target *surfaces,
                              const Target *picture) {
    target_bind(picture);
    glDisable(GL_DEPTH_TEST);
    set_air(frame, program, surfaces->depth);
    program_set_int(program, "u_shows_distance", true);
    draw_over_all(frame, program);
}
