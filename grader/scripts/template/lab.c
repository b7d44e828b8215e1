// Lab @ID@: @TITLE@. Say here in a sentence what is built.
#include "lab.h"

enum { KNOB_BRIGHTNESS };
enum { PROGRAM_SHADE };

static bool create(const Frame *frame) {
    UNUSED(frame);
    return true;
}

static void destroy(void) {
}

static void draw_picture(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADE];
    frame_bind(frame);
#ifdef SOLUTION // @N@.2
    program_set_float(program, "u_brightness", frame->knobs[KNOB_BRIGHTNESS]);
#else
    // TODO(@N@.2): give the shader the knob: set its u_brightness. Look up: program_set_float in
    // common/program.h.
#endif
    draw_scene(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
}

const Lab lab = {
    .title = "@TITLE@",
    .programs = {[PROGRAM_SHADE] = {"scene.vert", "shade.frag", NULL}},
    .knobs = {[KNOB_BRIGHTNESS] = {"brightness", "", 0, 1, 1}},
    .passes = {{"picture", draw_picture}},
    .create = create,
    .destroy = destroy,
};
