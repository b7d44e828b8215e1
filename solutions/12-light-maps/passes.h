// Given: what the passes share. The textures, the maps, and drawing into them.
#pragma once

#include "luxels.h"
#include "shadow_map.h"

#include <string.h>

static struct {
    Atlas atlas;             // the charts; its texels are the shares of the lamp
    GLuint by_rays;          // these texels as a texture
    Target bare, light_map;  // before and after dilation
    ShadowMap still, moving; // shadow maps of what stands still, and of what moves
    Scene baked;             // for what the light map was baked
    bool is_flat, is_baked;
} state;

static bool create(const Frame *frame) {
    int size = (int)frame->knobs[KNOB_MAP_SIZE];
    state.by_rays = gl_create_grey_texture();
    return shadow_map_create(&state.still, size, GL_DEPTH_COMPONENT24) &&
           shadow_map_create(&state.moving, size, GL_DEPTH_COMPONENT24);
}

static void destroy(void) {
    glDeleteTextures(1, &state.by_rays);
    target_destroy(&state.bare);
    target_destroy(&state.light_map);
    shadow_map_destroy(&state.still);
    shadow_map_destroy(&state.moving);
    atlas_destroy(&state.atlas);
    memset(&state, 0, sizeof state);
}

// Is the light map still the one of this frame? Then nothing is baked. What moves, and the camera, may
// change.
static bool is_baked(const Frame *frame) {
    Scene scene = *frame->scene;
    scene.camera = scene.second_camera = (Camera){0};
    for (int i = 0; i < scene.object_count; i++)
        if (moves(&scene.objects[i]))
            scene.objects[i] = (Object){.shape = scene.objects[i].shape};
    bool same = state.is_baked && state.is_flat == frame->flat_light &&
                memcmp(&scene, &state.baked, sizeof scene) == 0;
    state.baked = scene;
    state.is_flat = frame->flat_light;
    return same;
}

// Draws a part of the scene into a shadow map, both faces of everything, with a bias.
static void draw_map(const Frame *frame, const ShadowMap *map, const Scene *part) {
    Frame of_part = *frame;
    of_part.scene = part;
    shadow_map_begin(map);
    glDisable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    draw_scene(&of_part, &frame->programs[PROGRAM_DEPTH], shadow_map_clip_from_world(&part->lights[0]),
               part->lights[0].position);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_CULL_FACE);
}

// The shares of the lamp become a texture.
static void upload_shares(void) {
    glBindTexture(GL_TEXTURE_2D, state.by_rays);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, state.atlas.width, state.atlas.height, 0, GL_RED, GL_FLOAT,
                 state.atlas.texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

// Draws what stands still in texture space: no depth, for no two faces lie on each other there.
static void draw_luxels(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_BAKE];
    target_bind(&state.bare);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    program_set_texture(program, "u_by_rays", 0, GL_TEXTURE_2D, state.by_rays);
    program_set_texture(program, "u_still", 1, GL_TEXTURE_2D, state.still.texture);
    program_set_int(program, "u_shadows", (int)frame->knobs[KNOB_SHADOWS]);
    program_set_int(program, "u_pattern", (int)frame->knobs[KNOB_PATTERN]);
    program_set_int(program, "u_width", state.bare.width);
    program_set_int(program, "u_height", state.bare.height);
    program_set_vec4s(program, "u_charts", state.atlas.rectangles, ATLAS_MAX_CHARTS);
    mat4s light_clip_from_world = shadow_map_clip_from_world(&frame->scene->lights[0]);
    program_set_mat4(program, "u_light_clip_from_world", light_clip_from_world);
    draw_begin(frame, program, light_clip_from_world, frame->scene->lights[0].position);
    for (int i = 0; i < frame->scene->object_count; i++)
        if (!moves(&frame->scene->objects[i]))
            draw_object(frame, program, i);
    glEnable(GL_DEPTH_TEST);
}

// Draws the light map from the bare luxels.
static void draw_dilated(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_DILATE];
    target_bind(&state.light_map);
    glDisable(GL_DEPTH_TEST);
    program_set_texture(program, "u_bare", 0, GL_TEXTURE_2D, state.bare.color);
    program_set_int(program, "u_padding", state.atlas.padding);
    draw_fullscreen(program);
    glEnable(GL_DEPTH_TEST);
}
