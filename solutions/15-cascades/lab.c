// Lab 15: cascaded shadow maps. What the camera sees is cut into slices, and each has a map of the sun.
#include "lab.h"
#include "maps.h"
#include "show.h"
#include "slices.h"
#include "sun_map.h"

static struct {
    Maps maps;
    Shown shown;
} state;

static bool create(const Frame *frame) {
    return maps_create(&state.maps, (int)frame->knobs[KNOB_MAP_SIZE], MOST_SLICES) &&
           shown_create(&state.shown, frame, state.maps.size);
}

static void destroy(void) {
    maps_destroy(&state.maps);
    shown_destroy(&state.shown);
}

static void draw_maps(const Frame *frame) {
    const Light *light = &frame->scene->lights[0];
    maps_begin(&state.maps, frame->knobs[KNOB_BIAS] > 0);
#ifdef SOLUTION // 15.4
    glEnable(GL_DEPTH_CLAMP);
#else
    // TODO(15.4): what is nearer to the sun than the slice's sphere is cut off, and throws no shadow into it.
    // Let its depth be that of the near plane instead. Look up: GL_DEPTH_CLAMP.
#endif
    for (int i = 0; i < (int)frame->knobs[KNOB_SLICES]; i++) {
        maps_begin_layer(&state.maps, i);
        draw_scene(frame, &frame->programs[PROGRAM_DEPTH],
                   find_slice(frame, state.maps.size, i).clip_from_world, light->position);
    }
    maps_end();
}

// The scene with its shadows; or with the slices' colours.
static void shade(const Frame *frame, bool show_slices) {
    const Program *program = &frame->programs[PROGRAM_SHADE];
    const Camera *camera = &frame->scene->camera;
    vec4s ends = {{0}}, texels = {{0}};
    for (int i = 0; i < (int)frame->knobs[KNOB_SLICES]; i++) {
        const Slice slice = find_slice(frame, state.maps.size, i);
        ends.raw[i] = slice.end;
        texels.raw[i] = slice.texel;
        maps_set_matrix(program, i, slice.clip_from_world);
    }
    program_set_texture(program, "u_maps", 0, GL_TEXTURE_2D_ARRAY, state.maps.texture);
    program_set_int(program, "u_count", (int)frame->knobs[KNOB_SLICES]);
    program_set_int(program, "u_show_slices", show_slices);
    program_set_vec4s(program, "u_ends", &ends, 1);
    program_set_vec4s(program, "u_texels", &texels, 1);
    program_set_float(program, "u_near", camera->near_plane);
    program_set_float(program, "u_blend", frame->knobs[KNOB_BLEND]);
    program_set_float(program, "u_offset", frame->knobs[KNOB_BIAS] > 0 ? frame->knobs[KNOB_OFFSET] : 0);
    program_set_vec3(program, "u_axis_world", camera_axis(camera));
    draw_scene(frame, program, frame_clip_from_world(frame), camera->eye);
}

static void draw_picture(const Frame *frame) {
    frame_bind(frame);
    shade(frame, false);
}

// What the stages show.
static void show(const Frame *frame) {
    Slice slices[MOST_SLICES];
    int count = (int)frame->knobs[KNOB_SLICES];
    for (int i = 0; i < count; i++)
        slices[i] = find_slice(frame, state.maps.size, i);
    show_numbers(&state.shown, frame, slices, count);
    if (frame_shows(frame, "maps"))
        show_maps(&state.shown, frame, &state.maps, slices, count);
    if (!frame_shows(frame, "slices"))
        return;
    show_slices_begin(&state.shown);
    shade(frame, true);
}

const Lab lab = {
    .title = "Cascaded shadow maps",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADE] = {"scene.vert", "shade.frag", NULL},
                 [PROGRAM_SHOW] = {"fullscreen.vert", "show.frag", NULL}},
    .knobs = {[KNOB_SLICES] = {"slices", "", 1, MOST_SLICES, MOST_SLICES},
              [KNOB_LAMBDA] = {"lambda", "of the logarithm", 0, 1, 0.7f},
              [KNOB_MAP_SIZE] = {"map size", "texels", 16, 1024, 256},
              [KNOB_SNAP] = {"snap", "", 0, 1, 1, {"off", "on"}},
              [KNOB_BIAS] = {"bias", "", 0, 1, 0, {"polygon offset", "normal offset"}},
              [KNOB_OFFSET] = {"offset", "texels", 0, 4, 1},
              [KNOB_BLEND] = {"blend", "of a slice", 0, 0.5f, 0.15f}},
    .passes = {{"maps", draw_maps, PASS_PREPARE}, {"picture", draw_picture}, {"stages", show, PASS_SHOW}},
    .stages = {{"borders", &state.shown.borders.color},
               {"spheres", &state.shown.spheres.color},
               {"maps", &state.shown.maps.color},
               {"slices", &state.shown.slices.color}},
    .create = create,
    .destroy = destroy,
};
