// Lab 01: subroutines. The two halves of the picture are shaded by different functions of one program.
#include "lab.h"

enum { KNOB_LEFT_MODEL, KNOB_RIGHT_MODEL, KNOB_FINISH };
enum { PROGRAM_SHADE, PROGRAM_DIVIDER };

// What the knobs choose among: functions of shade.frag.
static const char *const models[] = {"shade_ambient", "shade_diffuse", "shade_phong", "normal_as_color"};
static const char *const finishes[] = {"finish_plain", "finish_posterised", "normal_as_color"};

static const char *model_of(const Frame *frame, int knob) {
    return models[(int)frame->knobs[knob]];
}

static const char *finish_of(const Frame *frame) {
    return finishes[(int)frame->knobs[KNOB_FINISH]];
}

// Enters `function` of the fragment shader into the array of glUniformSubroutinesuiv, for the subroutine
// uniform `uniform`. Changes nothing where the program has no such uniform.
static void enter(GLuint indices[], GLuint program, const char *uniform, const char *function) {
    // TODO(1.2): indices[l] = i, where l is the location of the uniform (-1: there is none, do nothing) and i
    // the index of the function. Look up: glGetSubroutineUniformLocation, glGetSubroutineIndex.
    UNUSED(indices, program, uniform, function);
}

// Points u_shade and u_finish of the program, which must be in use, to these functions.
static void choose(GLuint program, const char *model, const char *finish) {
    GLuint indices[4] = {0};
    enter(indices, program, "u_shade", model);
    // TODO(1.5), in C: enter `finish` for u_finish, too.
    UNUSED(finish);
    // TODO(1.2), second part: hand all indices over at once. Their number must be that of the locations: ask
    // glGetProgramStageiv for GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS. Look up: glUniformSubroutinesuiv.
}

// Limits what is drawn to the columns from `left` to `right`, shares of the picture's width.
static void limit_columns(const Frame *frame, float left, float right) {
    int first = (int)((float)frame->width * left), end = (int)((float)frame->width * right);
    glEnable(GL_SCISSOR_TEST);
    glScissor(first, 0, end - first, frame->height);
}

static void draw_left_half(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADE];
    limit_columns(frame, 0, 0.5f);
    // glUseProgram is called in draw_begin.
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    // TODO(1.2), third part: choose the model of KNOB_LEFT_MODEL and the finish. (Why not before draw_begin?)
    UNUSED(choose, model_of, finish_of);
    draw_objects(frame, program);
}

static void draw_divider(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_DIVIDER];
    limit_columns(frame, 0.495f, 0.505f);
    glDisable(GL_DEPTH_TEST);
    program_set_vec3(program, "u_color", vec3_make(1, 1, 1));
    draw_fullscreen(program);
    glEnable(GL_DEPTH_TEST);
}

static void draw_right_half(const Frame *frame) {
    const Program *program = &frame->programs[PROGRAM_SHADE];
    limit_columns(frame, 0.505f, 1);
    draw_begin(frame, program, frame_clip_from_world(frame), frame->scene->camera.eye);
    // TODO(1.4): the divider has used another program, and glUseProgram has forgotten what was chosen for
    // this one: choose again, with KNOB_RIGHT_MODEL.
    draw_objects(frame, program);
}

static bool create(const Frame *frame) {
    (void)frame;
    return true;
}

static void destroy(void) {
}

const Lab lab = {
    .title = "Subroutines",
    .programs = {[PROGRAM_SHADE] = {"scene.vert", "shade.frag", NULL},
                 [PROGRAM_DIVIDER] = {"fullscreen.vert", "flat.frag", NULL}},
    .knobs = {[KNOB_LEFT_MODEL] = {"left model", "", 0, 3, 1, {"ambient", "diffuse", "Phong", "normal"}},
              [KNOB_RIGHT_MODEL] = {"right model", "", 0, 3, 2, {"ambient", "diffuse", "Phong", "normal"}},
              [KNOB_FINISH] = {"finish", "", 0, 2, 0, {"plain", "posterised", "normal"}}},
    .passes = {{"left half", draw_left_half}, {"divider", draw_divider}, {"right half", draw_right_half}},
    .create = create,
    .destroy = destroy,
};
