// Lab 14: percentage-closer soft shadows. The kernel of each point is as wide as the penumbra there.
#include "lab.h"
#include "lamp.h"
#include "shadow_map.h"
#include "target.h"

enum { KNOB_MAP_SIZE, KNOB_SEARCH_TAPS, KNOB_FILTER_TAPS, KNOB_KERNEL, KNOB_SIDE, KNOB_LAMP, KNOB_SEARCH };
enum { PROGRAM_DEPTH, PROGRAM_SHADOW, PROGRAM_SHOW };
enum { SHOWN_DISTANCES, SHOWN_KERNELS, SHOWN_BLOCKERS, SHOWN_COUNT };

static struct {
    ShadowMap map;
    Target shown[SHOWN_COUNT];
} state;

static bool create(const Frame *frame) {
    for (int i = 0; i < SHOWN_COUNT; i++)
        if (!target_create(&state.shown[i], frame->width, frame->height, GL_RGBA8, GL_DEPTH_COMPONENT24))
            return false;
    return shadow_map_create(&state.map, (int)frame->knobs[KNOB_MAP_SIZE], GL_DEPTH_COMPONENT32F);
}

static void destroy(void) {
    shadow_map_destroy(&state.map);
    for (int i = 0; i < SHOWN_COUNT; i++)
        target_destroy(&state.shown[i]);
}

// The bias is given: only back faces are in the map, so a lit face has no depth there to quarrel with (lab
// 04), however wide the kernel is.
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

// The side of the square lamp; the knob lets it grow and shrink.
static float lamp_side(const Light *light, float scale) {
    // TODO(14.7): every lamp is 1.5 wide. Ask the light: its extent is half of the side (see scene.h), and
    // the knob scales it.
    UNUSED(light, scale);
    return 1.5f;
}

static void set_uniforms(const Frame *frame, const Program *program) {
    const Light *light = &frame->scene->lights[0];
    const float *knobs = frame->knobs;
    bool from_caster = knobs[KNOB_SEARCH] > 0;
    program_set_texture(program, "u_shadow_map", 0, GL_TEXTURE_2D, state.map.texture);
    program_set_mat4(program, "u_light_clip_from_world", shadow_map_clip_from_world(light));
    program_set_float(program, "u_near", light->near_plane);
    program_set_float(program, "u_far", light->far_plane);
    program_set_float(program, "u_map_tangent", tanf(light->fov_y / 2));
    program_set_float(program, "u_lamp_side", lamp_side(light, knobs[KNOB_LAMP]));
    program_set_float(program, "u_search_from",
                      from_caster ? nearest_caster(frame->scene) : light->near_plane);
    program_set_int(program, "u_search_taps", (int)knobs[KNOB_SEARCH_TAPS]);
    program_set_int(program, "u_filter_taps", (int)knobs[KNOB_FILTER_TAPS]);
    program_set_int(program, "u_fixed", knobs[KNOB_KERNEL] <= 0);
    program_set_float(program, "u_fixed_side", knobs[KNOB_SIDE] / 100);
}

static void draw_picture(const Frame *frame) {
    frame_bind(frame);
    set_uniforms(frame, &frame->programs[PROGRAM_SHADOW]);
    draw_scene(frame, &frame->programs[PROGRAM_SHADOW], frame_clip_from_world(frame),
               frame->scene->camera.eye);
}

static void show(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHOW];
    for (int i = 0; i < SHOWN_COUNT; i++) {
        if (!frame_shows(frame, lab.stages[i].name))
            continue;
        target_bind(&state.shown[i]);
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        set_uniforms(frame, program);
        program_set_int(program, "u_shown", i);
        draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    }
}

const Lab lab = {
    .title = "Percentage-closer soft shadows",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADOW] = {"scene.vert", "shadow.frag", NULL},
                 [PROGRAM_SHOW] = {"scene.vert", "show.frag", NULL}},
    .knobs = {[KNOB_MAP_SIZE] = {"map size", "texels", 32, 2048, 512},
              [KNOB_SEARCH_TAPS] = {"search taps", "along a side", 1, 16, 8},
              [KNOB_FILTER_TAPS] = {"filter taps", "along a side", 1, 24, 10},
              [KNOB_KERNEL] = {"kernel", "", 0, 1, 1, {"fixed", "from blockers"}},
              [KNOB_SIDE] = {"fixed side", "% of the map", 0, 20, 3},
              [KNOB_LAMP] = {"lamp", "of its size", 0, 2, 1},
              [KNOB_SEARCH] = {"search", "", 0, 1, 1, {"near plane", "nearest caster"}}},
    .passes = {{"shadow map", draw_map, PASS_PREPARE},
               {"picture", draw_picture},
               {"stages", show, PASS_SHOW}},
    .stages = {{"distances", &state.shown[SHOWN_DISTANCES].color},
               {"kernels", &state.shown[SHOWN_KERNELS].color},
               {"blockers", &state.shown[SHOWN_BLOCKERS].color}},
    .create = create,
    .destroy = destroy,
};
