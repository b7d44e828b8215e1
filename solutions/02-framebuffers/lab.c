// Lab 02: framebuffers. Draw the scene into a texture and show the texture on a screen
// that stands in the scene.
#include "lab.h"

enum { KNOB_TEXTURE_SIZE, KNOB_FULL_SCREEN };
enum { PROGRAM_SCENE, PROGRAM_SCREEN, PROGRAM_DEPTH_VIEW };

static struct {
    GLuint color_framebuffer, color_texture, depth_renderbuffer; // tasks 2.1 and 2.2
    GLuint depth_framebuffer, depth_texture;                     // task 2.4
    int size;                                                    // width and height of all of them, texels
} state;

static bool create_color_target(void) {
#ifdef SOLUTION // 2.1
    glGenTextures(1, &state.color_texture);
    glBindTexture(GL_TEXTURE_2D, state.color_texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, state.size, state.size, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);

    glGenRenderbuffers(1, &state.depth_renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, state.depth_renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, state.size, state.size);

    glGenFramebuffers(1, &state.color_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, state.color_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, state.color_texture, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, state.depth_renderbuffer);
    glDrawBuffers(1, (GLenum[]){GL_COLOR_ATTACHMENT0});
    return gl_check_framebuffer("colour target");
#else
    // TODO(2.1): make a colour texture (GL_RGBA8, GL_LINEAR) and a depth renderbuffer (GL_DEPTH_COMPONENT24),
    // both state.size x state.size, and attach them to a new framebuffer. Look up: glTexImage2D,
    // glRenderbufferStorage, glFramebufferTexture2D, glFramebufferRenderbuffer, glDrawBuffers.
    return true; // then: return gl_check_framebuffer("colour target");
#endif
}

static bool create_depth_target(void) {
#ifdef SOLUTION // 2.4
    glGenTextures(1, &state.depth_texture);
    glBindTexture(GL_TEXTURE_2D, state.depth_texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, state.size, state.size, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);

    glGenFramebuffers(1, &state.depth_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, state.depth_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, state.depth_texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return gl_check_framebuffer("depth target");
#else
    // TODO(2.4): make a depth texture (GL_DEPTH_COMPONENT24, GL_NEAREST), state.size x
    // state.size, and attach it to a new framebuffer that has no colour at all. Look up:
    // glTexImage2D, glFramebufferTexture2D, glDrawBuffer.
    return true; // then: return gl_check_framebuffer("depth target");
#endif
}

static bool create(const Frame *frame) {
    state.size = (int)frame->knobs[KNOB_TEXTURE_SIZE];
    return create_color_target() && create_depth_target();
}

static void destroy(void) {
    glDeleteFramebuffers(1, &state.color_framebuffer);
    glDeleteFramebuffers(1, &state.depth_framebuffer);
    glDeleteTextures(1, &state.color_texture);
    glDeleteTextures(1, &state.depth_texture);
    glDeleteRenderbuffers(1, &state.depth_renderbuffer);
    state.color_framebuffer = state.depth_framebuffer = 0;
    state.color_texture = state.depth_texture = state.depth_renderbuffer = 0;
}

// What the screen shows: the scene as a second camera sees it, in a square picture.
static void draw_second_view(const Frame *frame) {
    const Camera *camera = &frame->scene->second_camera;
    mat4s clip_from_world = glms_mat4_mul(camera_clip_from_view(camera, 1), camera_view_from_world(camera));
    draw_scene(frame, &frame->programs[PROGRAM_SCENE], clip_from_world, camera->eye);
}

static void draw_into_color_texture(const Frame *frame) {
#ifdef SOLUTION // 2.2
    glBindFramebuffer(GL_FRAMEBUFFER, state.color_framebuffer);
    glViewport(0, 0, state.size, state.size);
    glClearColor(0.8f, 0.85f, 0.9f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_second_view(frame);
#else
    // TODO(2.2): bind the colour framebuffer, set the viewport to all of the texture, clear
    // colour (to 0.8, 0.85, 0.9) and depth, and call draw_second_view(frame). Look up:
    // glBindFramebuffer, glViewport, glClear.
    UNUSED(frame, draw_second_view);
#endif
}

static void draw_into_depth_texture(const Frame *frame) {
#ifdef SOLUTION // 2.4
    glBindFramebuffer(GL_FRAMEBUFFER, state.depth_framebuffer);
    glViewport(0, 0, state.size, state.size);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw_second_view(frame);
#else
    // TODO(2.4): the same as in 2.2 for the depth framebuffer.
    UNUSED(frame);
#endif
}

static void draw_picture(const Frame *frame) {
#ifdef SOLUTION // 2.3
    glBindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    glViewport(0, 0, frame->width, frame->height);
#else
    // TODO(2.3): back to the picture: bind frame->framebuffer and set the viewport to frame->width x
    // frame->height. Until then nothing is drawn here while a texture is bound: it would lose what 2.2 and
    // 2.4 have drawn into it.
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    if ((GLuint)bound != frame->framebuffer)
        return;
#endif
    const Program *program =
        &frame->programs[frame->knobs[KNOB_FULL_SCREEN] > 0 ? PROGRAM_DEPTH_VIEW : PROGRAM_SCREEN];
    if (frame->knobs[KNOB_FULL_SCREEN] > 0) {
        glDisable(GL_DEPTH_TEST);
        program_set_texture(program, "u_depth_texture", 0, GL_TEXTURE_2D, state.depth_texture);
        program_set_float(program, "u_near", frame->scene->second_camera.near_plane);
        program_set_float(program, "u_far", frame->scene->second_camera.far_plane);
        draw_fullscreen(program);
        return;
    }
    program_set_texture(program, "u_texture", 0, GL_TEXTURE_2D, state.color_texture);
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

const Lab lab = {
    .title = "Framebuffers",
    .programs = {[PROGRAM_SCENE] = {"scene.vert", "unshadowed.frag", NULL},
                 [PROGRAM_SCREEN] = {"scene.vert", "screen.frag", NULL},
                 [PROGRAM_DEPTH_VIEW] = {"fullscreen.vert", "depth_view.frag", NULL}},
    .knobs = {[KNOB_TEXTURE_SIZE] = {"texture size", "texels", 16, 2048, 256},
              [KNOB_FULL_SCREEN] = {"full screen", "", 0, 1, 0, {"scene", "depth"}}},
    .passes = {{"colour texture", draw_into_color_texture, PASS_PREPARE},
               {"depth texture", draw_into_depth_texture, PASS_PREPARE},
               {"picture", draw_picture}},
    .stages = {{"colour texture", &state.color_texture}, {"depth texture", &state.depth_texture}},
    .create = create,
    .destroy = destroy,
};
