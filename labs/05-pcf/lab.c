// Lab 05: percentage-closer filtering. Compare many texels of the shadow map and average the answers.
#include "lab.h"

enum { KNOB_METHOD, KNOB_RADIUS, KNOB_MAP_SIZE };
enum { PROGRAM_DEPTH, PROGRAM_SHADOW };
enum { UNIT_DEPTHS, UNIT_COMPARED };

// As in shadow.frag.
enum { METHOD_HARD, METHOD_BY_HAND, METHOD_LINEAR, METHOD_DIAGONALS, METHOD_BOX, METHOD_GATHER };

static struct {
    ShadowMap map;
    GLuint depths; // a sampler: shows the shader the map's depths, whatever the texture's own parameters say
} state;

// What task 5.2 sets on the texture must not disturb those who read plain depths: a sampler object replaces
// the parameters of the texture that is bound to the same unit.
static void create_sampler(void) {
    glGenSamplers(1, &state.depths);
    glSamplerParameteri(state.depths, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(state.depths, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(state.depths, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(state.depths, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(state.depths, GL_TEXTURE_BORDER_COLOR, (float[]){1, 1, 1, 1});
}

static bool create(const Frame *frame) {
    create_sampler();
    if (!shadow_map_create(&state.map, (int)frame->knobs[KNOB_MAP_SIZE], GL_DEPTH_COMPONENT24))
        return false;
    glBindTexture(GL_TEXTURE_2D, state.map.texture);
    // TODO(5.2): let a lookup compare: its answer is 1 where (reference <= depth of the texel), else 0, and a
    // blend of the answers of four texels between their centres. Look up: glTexParameteri with
    // GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC and the two filters.
    return true;
}

static void destroy(void) {
    shadow_map_destroy(&state.map);
    glDeleteSamplers(1, &state.depths);
    state.depths = 0;
}

// How far from the point the outermost texel centre lies that the method may ask, along x or y, texels.
static float tap_reach(int method, float radius) {
    // TODO(5.6): the farthest tap's offset, plus what its filter adds: 1/2 for the nearest texel, 1 for the
    // linear filter. As it stands it is right for METHOD_HARD alone.
    UNUSED(method, radius);
    return 0.5f;
}

static void draw_map(const Frame *frame) {
    const Light *light = &frame->scene->lights[0];
    float reach = tap_reach((int)frame->knobs[KNOB_METHOD], frame->knobs[KNOB_RADIUS]);
    shadow_map_begin(&state.map);
    glEnable(GL_POLYGON_OFFSET_FILL);
    // TODO(5.6), second part: from a point to a texel `reach` away in x and in y, the depth of a plane
    // changes by up to reach * (|dz/dx| + |dz/dy|). One unit of the factor gives max(|dz/dx|, |dz/dy|). Which
    // factor is always enough?
    UNUSED(reach);
    glPolygonOffset(1, 2);
    draw_scene(frame, &frame->programs[PROGRAM_DEPTH], shadow_map_clip_from_world(light), light->position);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADOW];
    frame_bind(frame);
    program_set_mat4(program, "u_light_clip_from_world",
                     shadow_map_clip_from_world(&frame->scene->lights[0]));
    program_set_int(program, "u_method", (int)frame->knobs[KNOB_METHOD]);
    program_set_int(program, "u_radius", (int)frame->knobs[KNOB_RADIUS]);
    program_set_texture(program, "u_depths", UNIT_DEPTHS, GL_TEXTURE_2D, state.map.texture);
    program_set_texture(program, "u_shadow_map", UNIT_COMPARED, GL_TEXTURE_2D, state.map.texture);
    glBindSampler(UNIT_DEPTHS, state.depths);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    glBindSampler(UNIT_DEPTHS, 0);
}

const Lab lab = {
    .title = "Percentage-closer filtering",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADOW] = {"scene.vert", "shadow.frag", NULL}},
    .knobs = {[KNOB_METHOD] = {"method", "", METHOD_HARD, METHOD_GATHER, METHOD_BOX,
                               .choices = {"hard", "by hand", "linear", "diagonals", "box", "gather"}},
              [KNOB_RADIUS] = {"kernel radius", "texels", 0, 8, 2},
              [KNOB_MAP_SIZE] = {"map size", "texels", 16, 4096, 256}},
    .passes = {{"shadow map", draw_map, PASS_PREPARE}, {"picture", draw_picture}},
    .stages = {{"shadow map", &state.map.texture}},
    .create = create,
    .destroy = destroy,
};
