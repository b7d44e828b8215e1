// Lab 04: acne and bias. Five ways to keep a surface from shadowing itself, and what each of them costs.
#include "lab.h"

enum {
    KNOB_METHOD,
    KNOB_MAP_SIZE,
    KNOB_BIAS,
    KNOB_SLOPE_BIAS,
    KNOB_FACTOR,
    KNOB_UNITS,
    KNOB_NORMAL_OFFSET,
    KNOB_DEPTH_FORMAT
};
enum { PROGRAM_DEPTH, PROGRAM_SHADOW };

// Values of KNOB_METHOD, as in shadow.frag.
enum {
    METHOD_NONE,
    METHOD_CONSTANT,
    METHOD_SLOPE,
    METHOD_POLYGON_OFFSET,
    METHOD_FRONT_FACES,
    METHOD_NORMAL_OFFSET
};

static ShadowMap map;

static bool create(const Frame *frame) {
    int bits = (int)frame->knobs[KNOB_DEPTH_FORMAT];
    GLenum format = bits == 16   ? GL_DEPTH_COMPONENT16
                    : bits == 24 ? GL_DEPTH_COMPONENT24
                                 : GL_DEPTH_COMPONENT32F;
    return shadow_map_create(&map, (int)frame->knobs[KNOB_MAP_SIZE], format);
}

static void destroy(void) {
    shadow_map_destroy(&map);
}

static void draw_map(const Frame *frame) {
    const Light *light = &frame->scene->lights[0];
    int method = (int)frame->knobs[KNOB_METHOD];
    if (method == METHOD_POLYGON_OFFSET) {
        // TODO(4.3): push the map's depths away from the light, by factor * the polygon's slope (per texel)
        // + units * the least step of the depth buffer. Look up: glPolygonOffset, glEnable with
        // GL_POLYGON_OFFSET_FILL; the knobs are frame->knobs[KNOB_FACTOR] and [KNOB_UNITS].
    }
    if (method == METHOD_FRONT_FACES) {
        // TODO(4.4): let only the faces that look away from the light into the map. Culling is on and leaves
        // out GL_BACK, which is what the picture needs. Look up: glCullFace.
    }
    shadow_map_begin(&map);
    draw_scene(frame, &frame->programs[PROGRAM_DEPTH], shadow_map_clip_from_world(light), light->position);
    // TODO(4.3), second part: the picture is drawn without the offset. Look up: glDisable.
    // TODO(4.4), second part: the picture shows the front faces again.
}

// Width of one texel in world units: at distance 1 from a spot light, anywhere for a directional one.
static float texel_size(const Light *light) {
    // TODO(4.5): the map shows a square of map.size x map.size texels. Its side is 2 tan(light->fov_y / 2) at
    // distance 1 from a LIGHT_SPOT, and 2 light->half_size for a directional light.
    UNUSED(light);
    return 0;
}

static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADOW];
    const Light *light = &frame->scene->lights[0];
    frame_bind(frame);
    program_set_texture(program, "u_shadow_map", 0, GL_TEXTURE_2D, map.texture);
    program_set_mat4(program, "u_light_clip_from_world", shadow_map_clip_from_world(light));
    program_set_int(program, "u_method", (int)frame->knobs[KNOB_METHOD]);
    program_set_float(program, "u_bias", frame->knobs[KNOB_BIAS]);
    program_set_float(program, "u_slope_bias", frame->knobs[KNOB_SLOPE_BIAS]);
    program_set_float(program, "u_normal_offset", frame->knobs[KNOB_NORMAL_OFFSET]);
    program_set_float(program, "u_texel_size", texel_size(light));
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

const Lab lab = {
    .title = "Acne and bias",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADOW] = {"scene.vert", "shadow.frag", NULL}},
    .knobs = {[KNOB_METHOD] = {"method", "", 0, 5, 1,
                               .choices = {"none", "constant", "slope", "offset", "faces", "normal"}},
              [KNOB_MAP_SIZE] = {"map size", "texels", 64, 4096, 256},
              [KNOB_BIAS] = {"bias", "depth", 0, 0.1f, 0.01f},
              [KNOB_SLOPE_BIAS] = {"slope bias", "depth", 0, 0.2f, 0.03f},
              [KNOB_FACTOR] = {"factor", "slopes per texel", 0, 16, 2},
              [KNOB_UNITS] = {"units", "least depth steps", 0, 200000, 4},
              [KNOB_NORMAL_OFFSET] = {"normal offset", "texels", 0, 8, 1},
              [KNOB_DEPTH_FORMAT] = {"depth format", "bits: 16, 24, 32 (float)", 16, 32, 24}},
    .passes = {{"shadow map", draw_map, PASS_PREPARE}, {"picture", draw_picture}},
    .stages = {{"shadow map", &map.texture}},
    .create = create,
    .destroy = destroy,
};
