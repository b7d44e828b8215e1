// Lab 09: silhouettes on the CPU. Find each caster's silhouette, make its shadow volume, and count from the
// eye.
#include "frame_view.h"
#include "lab.h"
#include "stages.h"

static struct {
    FrameView view; // for the stage "stencil counts"
} state;

static bool create(const Frame *frame) {
    return volumes_create() && stages_create(frame->width, frame->height) &&
           frame_view_create(&state.view, frame);
}

static void destroy(void) {
    frame_view_destroy(&state.view);
    stages_destroy();
    volumes_destroy();
}

static void draw_surfaces(const Frame *frame, bool lit) {
    Scene scene;
    const Frame moved = from_eye(frame, &scene);
    program_set_int(&frame->programs[PROGRAM_LIGHT], "u_is_lit", lit);
    draw_scene(&moved, &frame->programs[PROGRAM_LIGHT], frame_clip_from_world(&moved), scene.camera.eye);
}

// Pass 1: what is seen, in ambient light, and its depth.
static void draw_ambient(const Frame *frame) {
    draw_surfaces(frame, false);
}

// Z-pass counts faces from where the counting begins to what is seen.
static void begin_z_pass(void) {
#ifdef SOLUTION // 9.8
    glClearStencil(volumes.around_eye);
    glClear(GL_STENCIL_BUFFER_BIT);
#else
    // TODO(9.8): the eye is in some volumes already: volumes.around_eye. Clear the stencil to this number.
    // Look up: glClearStencil, glClear.
#endif
#ifdef SOLUTION // 9.9
    glEnable(GL_DEPTH_CLAMP);
#else
    // TODO(9.9): the number is right at the eye, but faces before the near plane are cut off and never
    // counted. Keep them: let their depth be clamped to the near plane's instead. Look up: glEnable,
    // GL_DEPTH_CLAMP.
#endif
}

// Given: counting as in lab 07, by z-pass or by z-fail.
static void set_stencil(int method) {
    GLenum in = method == Z_FAIL ? GL_BACK : GL_FRONT, out = method == Z_FAIL ? GL_FRONT : GL_BACK;
    GLenum fail = method == Z_FAIL, pass = !fail;
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOpSeparate(in, GL_KEEP, fail ? GL_INCR_WRAP : GL_KEEP, pass ? GL_INCR_WRAP : GL_KEEP);
    glStencilOpSeparate(out, GL_KEEP, fail ? GL_DECR_WRAP : GL_KEEP, pass ? GL_DECR_WRAP : GL_KEEP);
    (method == Z_FAIL ? glEnable : glDisable)(GL_DEPTH_CLAMP);
    glDepthFunc(method == Z_FAIL ? GL_LEQUAL : GL_LESS); // a cap at infinity is as far as the empty sky
    if (method == FROM_EYE)
        begin_z_pass();
}

// Pass 2: in the stencil the number of volumes around each visible point. Near caps lie on the faces of their
// casters: the polygon offset puts them just behind.
static void count_volumes(const Frame *frame) {
    Scene scene;
    const Frame moved = from_eye(frame, &scene);
    volumes_make(&moved);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, 16);
    set_stencil((int)frame->knobs[KNOB_METHOD]);
    shell_draw(&moved, &volumes.sides);
    shell_draw(&moved, &volumes.caps);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glEnable(GL_CULL_FACE);
}

// Pass 3: the same surfaces with the light, where no volume was counted.
static void draw_light(const Frame *frame) {
    glStencilFunc(GL_EQUAL, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glDepthFunc(GL_EQUAL);
    draw_surfaces(frame, true);
}

static void show_stages(const Frame *frame) {
    Scene scene;
    const Frame moved = from_eye(frame, &scene);
    frame_view_draw(&state.view, frame, 0, &frame->programs[PROGRAM_CONSTANT]);
    stages_draw(&moved);
}

const Lab lab = {
    .title = "Silhouettes on the CPU",
    .programs = {[PROGRAM_LIGHT] = {"scene.vert", "light.frag", NULL},
                 [PROGRAM_VOLUME] = {"volume.vert", "faces.frag", NULL},
                 [PROGRAM_CONSTANT] = {"fullscreen.vert", "constant.frag", NULL}},
    .knobs = {[KNOB_METHOD] = {"method", "", 0, 2, 1, {"z-pass from 0", "z-pass from the eye", "z-fail"}},
              [KNOB_SILHOUETTES] = {"silhouettes", "", 0, 1, 0, {"edge set", "neighbours"}},
              [KNOB_STRETCH] = {"stretch", "times the way from the light, 0: endless", 0, 4, 0}},
    .passes = {{"ambient", draw_ambient},
               {"volumes", count_volumes, PASS_PREPARE},
               {"light", draw_light},
               {"stages", show_stages, PASS_SHOW}},
    .stages = {{"lit faces", &stages.lit.color},
               {"silhouette", &stages.silhouette.color},
               {"sides", &stages.sides.color},
               {"caps", &stages.caps.color},
               {"around the eye", &stages.around_eye.color},
               {"stencil counts", &state.view.counts.color}},
    .create = create,
    .destroy = destroy,
};
