// Lab 06: random sampling. Many taps at random places of a disc, a few of them first: the
// others only where these differ.
#include "lab.h"

#include "offsets.h"

enum {
    KNOB_MAP_SIZE,
    KNOB_RADIUS,
    KNOB_COLUMNS,
    KNOB_ROWS,
    KNOB_PATTERN_SIZE,
    KNOB_EARLY_OUT,
    KNOB_SPIRAL,
    KNOB_CELLS
};
enum { PROGRAM_DEPTH, PROGRAM_SHADOW, PROGRAM_TAPS };
enum { LENS_SIZE = 64 };

static struct {
    ShadowMap map;
    Pattern pattern; // offsets.h
    Target lens;     // the taps of one pixel, to look at
} state;

static bool create(const Frame *frame) {
    int columns = (int)frame->knobs[KNOB_COLUMNS], rows = (int)frame->knobs[KNOB_ROWS];
    state.pattern = (Pattern){.size = (int)frame->knobs[KNOB_PATTERN_SIZE],
                              .columns = columns,
                              .rows = rows,
                              .layers = columns * rows / 2,
                              .spiral = frame->knobs[KNOB_SPIRAL] > 0,
                              .anywhere = frame->knobs[KNOB_CELLS] <= 0};
    return shadow_map_create(&state.map, (int)frame->knobs[KNOB_MAP_SIZE], GL_DEPTH_COMPONENT24) &&
           target_create(&state.lens, LENS_SIZE, LENS_SIZE, GL_RGBA8, 0) && pattern_create(&state.pattern);
}

static void destroy(void) {
    shadow_map_destroy(&state.map);
    target_destroy(&state.lens);
    glDeleteTextures(1, &state.pattern.offsets);
    state.pattern = (Pattern){0};
}

// The bias is given: only back faces are in the map, so a lit face has no depth there
// to quarrel with (lab 04).
static void draw_map(const Frame *frame) {
    const Light *light = &frame->scene->lights[0];
    shadow_map_begin(&state.map);
    glCullFace(GL_FRONT);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(2, 4);
    draw_scene(frame, &frame->programs[PROGRAM_DEPTH], shadow_map_clip_from_world(light), light->position);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glCullFace(GL_BACK);
}

static void set_textures(const Frame *frame, const Program *program) {
    program_set_texture(program, "u_shadow_map", 0, GL_TEXTURE_2D, state.map.texture);
    program_set_texture(program, "u_offsets", 1, GL_TEXTURE_3D, state.pattern.offsets);
    program_set_mat4(program, "u_light_clip_from_world",
                     shadow_map_clip_from_world(&frame->scene->lights[0]));
}

static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADOW];
    float radius = 0.02f;
    // TODO(6.5): the knob gives the disc's radius in texels of the map (KNOB_RADIUS); the shader wants it as
    // a part of the map's side, which has state.map.size texels.
    frame_bind(frame);
    set_textures(frame, program);
    program_set_float(program, "u_radius", radius);
    program_set_float(program, "u_pattern_size", (float)state.pattern.size);
    program_set_int(program, "u_layers", state.pattern.layers);
    program_set_int(program, "u_early_out", frame->knobs[KNOB_EARLY_OUT] > 0);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

// Given: a magnifying glass over the map, around the point in the middle of the picture,
// with the taps of its pixel.
static void draw_lens(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_TAPS];
    target_bind(&state.lens);
    set_textures(frame, program);
    program_set_vec3(program, "u_position_world", frame->scene->camera.target);
    program_set_vec3(program, "u_pixel", vec3_make((float)(frame->width / 2), (float)(frame->height / 2), 0));
    program_set_float(program, "u_radius_texels", frame->knobs[KNOB_RADIUS]);
    glDisable(GL_DEPTH_TEST);
    draw_fullscreen(program);
    glEnable(GL_DEPTH_TEST);
}

const Lab lab = {
    .title = "Random sampling",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADOW] = {"scene.vert", "shadow.frag", NULL},
                 [PROGRAM_TAPS] = {"fullscreen.vert", "taps.frag", NULL}},
    .knobs = {[KNOB_MAP_SIZE] = {"map size", "texels", 64, 4096, 256},
              [KNOB_RADIUS] = {"radius", "texels", 0, 64, 12},
              [KNOB_COLUMNS] = {"columns", "samples", 4, 16, 4},
              [KNOB_ROWS] = {"rows", "samples", 2, 16, 8},
              [KNOB_PATTERN_SIZE] = {"pattern size", "pixels", 1, 64, 8},
              [KNOB_EARLY_OUT] = {"early-out", "", 0, 1, 1, {"off", "on"}},
              [KNOB_SPIRAL] = {"spiral", "", 0, 1, 0, {"off", "on"}},
              [KNOB_CELLS] = {"cells", "", 0, 1, 1, {"off", "on"}}},
    .passes = {{"shadow map", draw_map, PASS_PREPARE},
               {"picture", draw_picture},
               {"lens", draw_lens, PASS_SHOW}},
    .stages = {{"shadow map", &state.map.texture}, {"lens", &state.lens.color}},
    .create = create,
    .destroy = destroy,
};
