// Given: what the stages show.
#pragma once

#include "lab.h"
#include "maps.h"
#include "slices.h"
#include "target.h"

enum { SHOWN_SIDE = 240, TILES = 2 };
enum { SHOW_BORDERS, SHOW_SPHERES, SHOW_MAPS };

typedef struct Shown {
    Target borders; // a row for each slice, from below; from left to right the logarithm of the distance
    Target spheres; // a tile for each slice: its section along a diagonal of the picture, and its sphere
    Target maps;    // a tile for each map
    Target slices;  // the scene in the slices' colours
} Shown;

static bool shown_create(Shown *shown, const Frame *frame, int map_size) {
    return target_create(&shown->borders, SHOWN_SIDE, SHOWN_SIDE / 2, GL_RGBA8, 0) &&
           target_create(&shown->spheres, SHOWN_SIDE, SHOWN_SIDE, GL_RGBA8, 0) &&
           target_create(&shown->maps, TILES * map_size, TILES * map_size, GL_RGBA8, 0) &&
           target_create(&shown->slices, frame->width, frame->height, GL_RGBA8, GL_DEPTH_COMPONENT24);
}

static void shown_destroy(Shown *shown) {
    target_destroy(&shown->borders);
    target_destroy(&shown->spheres);
    target_destroy(&shown->maps);
    target_destroy(&shown->slices);
}

static void fill(const Target *target, const Program *program, int what) {
    target_bind(target);
    program_set_int(program, "u_what", what);
    glDisable(GL_DEPTH_TEST);
    draw_fullscreen(program);
    glEnable(GL_DEPTH_TEST);
}

static void show_numbers(const Shown *shown, const Frame *frame, const Slice *slices, int count) {
    const Program *program = &frame->programs[PROGRAM_SHOW];
    const Camera *camera = &frame->scene->camera;
    vec4s rows[MOST_SLICES] = {{{0}}};
    for (int i = 0; i < count; i++)
        rows[i] = (vec4s){{slices[i].begin, slices[i].end, slices[i].centre, slices[i].radius}};
    program_set_vec4s(program, "u_slices", rows, MOST_SLICES);
    program_set_int(program, "u_count", count);
    program_set_float(program, "u_near", camera->near_plane);
    program_set_float(program, "u_far", camera->far_plane);
    program_set_float(program, "u_tangent",
                      tanf(camera->fov_y / 2) * hypotf(1, (float)frame->width / (float)frame->height));
    if (frame_shows(frame, "borders"))
        fill(&shown->borders, program, SHOW_BORDERS);
    if (frame_shows(frame, "spheres"))
        fill(&shown->spheres, program, SHOW_SPHERES);
}

// Depths as what they are in the world, so that the map's planes do not matter.
static void show_maps(const Shown *shown, const Frame *frame, const Maps *maps, const Slice *slices,
                      int count) {
    const Program *program = &frame->programs[PROGRAM_SHOW];
    const Scene *scene = frame->scene;
    for (int i = 0; i < count; i++)
        maps_set_matrix(program, i, slices[i].clip_from_world);
    program_set_texture(program, "u_maps", 0, GL_TEXTURE_2D_ARRAY, maps->texture);
    program_set_vec3(program, "u_eye_world", scene->camera.eye);
    program_set_vec3(program, "u_axis_world", camera_axis(&scene->camera));
    program_set_vec3(program, "u_to_sun_world",
                     glms_vec3_normalize(glms_vec3_sub(scene->lights[0].position, scene->lights[0].target)));
    fill(&shown->maps, program, SHOW_MAPS);
}

static void show_slices_begin(const Shown *shown) {
    target_bind(&shown->slices);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}
