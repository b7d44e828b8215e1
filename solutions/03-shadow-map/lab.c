// Lab 03: the basic shadow map. Draw the scene as the light sees it, keep the depths, and compare.
#include "lab.h"

enum { KNOB_MAP_SIZE };
enum { PROGRAM_DEPTH, PROGRAM_SHADOW };

static struct {
    GLuint map_framebuffer, map_texture; // task 3.1
    int size;                            // width and height of the map, texels
} state;

static bool create(const Frame *frame) {
    state.size = (int)frame->knobs[KNOB_MAP_SIZE];
#ifdef SOLUTION // 3.1
    glGenTextures(1, &state.map_texture);
    glBindTexture(GL_TEXTURE_2D, state.map_texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, state.size, state.size, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);

    glGenFramebuffers(1, &state.map_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, state.map_framebuffer);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, state.map_texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
#else
    // TODO(3.1): make a depth texture (GL_DEPTH_COMPONENT24, GL_NEAREST), state.size x
    // state.size, and a framebuffer that has it as its depth and no colour. Look up:
    // glTexImage2D, glFramebufferTexture, glDrawBuffer.
#endif
#ifdef SOLUTION // 3.6
    glBindTexture(GL_TEXTURE_2D, state.map_texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (float[]){1, 1, 1, 1});
#else
    // TODO(3.6): what lies outside the map is lit: let the texture return the depth 1 there. Look up:
    // glTexParameteri with GL_TEXTURE_WRAP_S, glTexParameterfv with GL_TEXTURE_BORDER_COLOR.
#endif
    return !state.map_framebuffer || gl_check_framebuffer("shadow map");
}

static void destroy(void) {
    glDeleteFramebuffers(1, &state.map_framebuffer);
    glDeleteTextures(1, &state.map_texture);
    state.map_framebuffer = state.map_texture = 0;
}

// From world space to the clip space of the light: the camera that draws the map.
static mat4s light_clip_from_world(const Light *light) {
    mat4s clip_from_light = glms_mat4_identity();
    mat4s light_from_world = glms_mat4_identity();
#ifdef SOLUTION // 3.2
    light_from_world = glms_lookat(light->position, light->target, vec3_make(0, 1, 0));
    if (light_is_overhead(light))
        light_from_world = light_view_from_overhead(light);
    if (light->kind == LIGHT_SPOT)
        clip_from_light = glms_perspective(light->fov_y, 1, light->near_plane, light->far_plane);
#else
    // TODO(3.2): light_from_world: the light stands at light->position and looks at light->target; up is +y.
    // (Looks it straight down, +y gives no view: light_view_from_overhead(light) does.) For a LIGHT_SPOT,
    // clip_from_light is a perspective projection with the light's fov_y and planes.
    // Look up: glms_lookat, glms_perspective.
#endif
#ifdef SOLUTION // 3.3
    float r = light->half_size;
    if (light->kind == LIGHT_DIRECTIONAL)
        clip_from_light = glms_ortho(-r, r, -r, r, light->near_plane, light->far_plane);
#else
    // TODO(3.3): for a LIGHT_DIRECTIONAL, clip_from_light is an orthographic projection of the square from
    // -light->half_size to light->half_size. Look up: glms_ortho.
    UNUSED(light);
#endif
    return glms_mat4_mul(clip_from_light, light_from_world);
}

static void draw_map(const Frame *frame) {
    const Light *light = &frame->scene->lights[0];
    glEnable(GL_POLYGON_OFFSET_FILL); // against shadow acne, the subject of the next lab
    glPolygonOffset(2, 4);
#ifdef SOLUTION // 3.4
    glBindFramebuffer(GL_FRAMEBUFFER, state.map_framebuffer);
    glViewport(0, 0, state.size, state.size);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw_scene(frame, &frame->programs[PROGRAM_DEPTH], light_clip_from_world(light), light->position);
#else
    // TODO(3.4): bind the map's framebuffer, set the viewport to the size of the map, clear its depth
    // and draw the scene with PROGRAM_DEPTH and the light's matrix. Look up: glViewport, glClear,
    // draw_scene in common/draw.h.
    UNUSED(light);
#endif
    glDisable(GL_POLYGON_OFFSET_FILL);
}

static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADOW];
    frame_bind(frame);
    program_set_texture(program, "u_shadow_map", 0, GL_TEXTURE_2D, state.map_texture);
    program_set_mat4(program, "u_light_clip_from_world", light_clip_from_world(&frame->scene->lights[0]));
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

const Lab lab = {
    .title = "Basic shadow map",
    .programs = {[PROGRAM_DEPTH] = {"scene.vert", "empty.frag", NULL},
                 [PROGRAM_SHADOW] = {"scene.vert", "shadow.frag", NULL}},
    .knobs = {[KNOB_MAP_SIZE] = {"map size", "texels", 64, 4096, 512}},
    .passes = {{"shadow map", draw_map, PASS_PREPARE}, {"picture", draw_picture}},
    .stages = {{"shadow map", &state.map_texture}},
    .create = create,
    .destroy = destroy,
};
