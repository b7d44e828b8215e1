// Lab 16: variance shadow maps. A map of moments may be blurred and shrunk like a picture.
#include "lab.h"
#include "moments.h"
#include "shadow_map.h"

enum { KNOB_MAP_SIZE, KNOB_BLUR, KNOB_SLOPE, KNOB_MIPMAPS, KNOB_LEAST, KNOB_CUT, KNOB_FORMAT };
enum { PROGRAM_MOMENTS, PROGRAM_BLUR, PROGRAM_SHADOW };

static Moments moments;

static bool create(const Frame *frame) {
    return moments_create(&moments, (int)frame->knobs[KNOB_MAP_SIZE],
                          frame->knobs[KNOB_FORMAT] > 0 ? GL_RG32F : GL_RG16F);
}

static void destroy(void) {
    moments_destroy(&moments);
}

static void set_light(const Program *program, const Light *light) {
    vec3s way = glms_vec3_sub(light->target, light->position);
    program_set_vec3(program, "u_light_position_world", light->position);
    program_set_vec3(program, "u_light_axis_world", glms_vec3_normalize(way));
    program_set_float(program, "u_light_near", light->near_plane);
    program_set_float(program, "u_light_far", light->far_plane);
}

static void draw_map(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_MOMENTS];
    const Light *light = &frame->scene->lights[0];
    moments_begin(&moments);
    set_light(program, light);
    program_set_int(program, "u_slope", frame->knobs[KNOB_SLOPE] > 0);
    draw_scene(frame, program, shadow_map_clip_from_world(light), light->position);
}

static void blur_map(const Frame *frame) {
    int radius = (int)frame->knobs[KNOB_BLUR];
    if (radius > 0)
        moments_blur(&moments, &frame->programs[PROGRAM_BLUR], radius);
    moments_filter(&moments, frame->knobs[KNOB_MIPMAPS] > 0);
}

static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADOW];
    const Light *light = &frame->scene->lights[0];
    frame_bind(frame);
    set_light(program, light);
    program_set_mat4(program, "u_light_clip_from_world", shadow_map_clip_from_world(light));
    program_set_texture(program, "u_moments", 0, GL_TEXTURE_2D, moments.map.color);
    program_set_float(program, "u_least_variance", frame->knobs[KNOB_LEAST] * 1e-6f);
    program_set_float(program, "u_cut", frame->knobs[KNOB_CUT]);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

const Lab lab = {
    .title = "Variance shadow maps",
    .programs = {[PROGRAM_MOMENTS] = {"scene.vert", "moments.frag", NULL},
                 [PROGRAM_BLUR] = {"fullscreen.vert", "blur.frag", NULL},
                 [PROGRAM_SHADOW] = {"scene.vert", "shadow.frag", NULL}},
    .knobs = {[KNOB_MAP_SIZE] = {"map size", "texels", 32, 2048, 256},
              [KNOB_BLUR] = {"blur", "texels", 0, 16, 3},
              [KNOB_SLOPE] = {"slope", "", 0, 1, 1, {"ignored", "counted"}},
              [KNOB_MIPMAPS] = {"mipmaps", "", 0, 1, 1, {"off", "on"}},
              [KNOB_LEAST] = {"least variance", "millionths", 1, 10000, 10},
              [KNOB_CUT] = {"cut", "of the light", 0, 0.9f, 0.2f},
              [KNOB_FORMAT] = {"numbers", "", 0, 1, 1, {"16 bits", "32 bits"}}},
    .passes = {{"moments", draw_map, PASS_PREPARE},
               {"blur", blur_map, PASS_PREPARE},
               {"picture", draw_picture}},
    .stages = {{"moments", &moments.map.color}},
    .create = create,
    .destroy = destroy,
};
