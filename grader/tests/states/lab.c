// A lab that leaves one state of states.h changed at the end of its frame, and says at the beginning of a
// frame, and of create, which ones are not as they were the first time.
#include "lab.h"

#include "states.h"

#include <string.h>

enum { KNOB_STATE }; // the number of the state; -1: none
enum { PROGRAM_SCENE };

static struct { Target target; } state;

static void bind_texture(GLenum target, GLuint unit) {
    GLuint texture;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
    glActiveTexture(GL_TEXTURE0);
}

static void bind_sampler(GLuint unit) {
    GLuint sampler;
    glGenSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glBindSampler(unit, sampler);
}

static GLuint create_buffer(GLenum target) {
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, 1 << 16, NULL, GL_DYNAMIC_DRAW);
    return buffer;
}

static void bind_buffer(GLenum target) {
    create_buffer(target);
}

static void bind_buffer_base(GLenum target, GLuint index) {
    const GLuint buffer = create_buffer(target);
    glBindBuffer(target, 0);
    glBindBufferBase(target, index, buffer);
}

static void bind_framebuffer(GLenum target) {
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(target, framebuffer);
}

static void bind_renderbuffer(void) {
    GLuint renderbuffer;
    glGenRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
}

static void bind_vertex_array(void) {
    GLuint array;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glEnableVertexAttribArray(0);
}

static void bind_pipeline(void) {
    GLuint pipeline;
    glGenProgramPipelines(1, &pipeline);
    glBindProgramPipeline(pipeline);
}

static GLuint feedback_program(void) {
    const char *text =
        "#version 410 core\nout float v_out;\nvoid main() { v_out = 1.0; gl_Position = vec4(0.0); }\n";
    const GLuint program = glCreateProgram(), shader = glCreateShader(GL_VERTEX_SHADER);
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glTransformFeedbackVaryings(program, 1, (const char *[]){"v_out"}, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    return program;
}

static void bind_feedback(void) {
    GLuint feedback;
    glGenTransformFeedbacks(1, &feedback);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
}

static void begin_feedback(void) {
    bind_feedback();
    bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glUseProgram(feedback_program());
    glBeginTransformFeedback(GL_POINTS);
}

static GLuint begin_query(GLenum target, GLuint stream) {
    GLuint query;
    glGenQueries(1, &query);
    glBeginQueryIndexed(target, stream, query);
    return query;
}

// Nothing passes the query, so nothing will be drawn.
static void begin_condition(void) {
    const GLuint query = begin_query(GL_SAMPLES_PASSED, 0);
    glEndQuery(GL_SAMPLES_PASSED);
    glBeginConditionalRender(query, GL_QUERY_WAIT);
}

typedef double Value[16];
typedef void Ask(Value value, GLenum name, GLuint index);

static void ask_get(Value value, GLenum name, GLuint index) {
    (void)index;
    glGetDoublev(name, value);
}

static void ask_indexed(Value value, GLenum name, GLuint index) {
    GLint values[16] = {0};
    glGetIntegeri_v(name, index, values);
    for (int i = 0; i < 16; i++)
        value[i] = values[i];
}

static void ask_enabled(Value value, GLenum name, GLuint index) {
    value[0] = glIsEnabledi(name, index);
}

static void ask_range(Value value, GLenum name, GLuint index) {
    glGetDoublei_v(name, index, value);
}

static void ask_unit(Value value, GLenum name, GLuint index) {
    glActiveTexture(GL_TEXTURE0 + index);
    glGetDoublev(name, value);
    glActiveTexture(GL_TEXTURE0);
}

static void ask_query(Value value, GLenum name, GLuint index) {
    GLint query = 0;
    glGetQueryIndexediv(name, index, GL_CURRENT_QUERY, &query);
    value[0] = query;
}

static void ask_attribute(Value value, GLenum name, GLuint index) {
    glGetVertexAttribdv(index, name, value);
}

// Whether it runs can only be seen by its being ended.
static void ask_condition(Value value, GLenum name, GLuint index) {
    (void)name, (void)index;
    glad_glEndConditionalRender();
    value[0] = glad_glGetError() == GL_NO_ERROR;
}

static const struct {
    const char *text;
    Ask *ask;
    GLenum name;
    GLuint index;
} states[] = {
#define STATE(ask, name, index, leave) {#name " " #index, ask_##ask, name, index},
    STATES(STATE)
#undef STATE
};
enum { STATE_COUNT = sizeof states / sizeof states[0] };

static void leave(int which) {
    int i = 0;
#define STATE(ask, name, index, leave)                                                                       \
    if (i++ == which)                                                                                        \
        leave;
    STATES(STATE)
#undef STATE
}

static void ask_all(Value *values) {
    memset(values, 0, STATE_COUNT * sizeof *values);
    for (int i = 0; i < STATE_COUNT; i++)
        states[i].ask(values[i], states[i].name, states[i].index);
}

typedef struct First {
    bool known;
    Value values[STATE_COUNT];
} First;

static void compare(First *first, const char *where) {
    static Value now[STATE_COUNT];
    ask_all(now);
    if (!first->known)
        memcpy(first->values, now, sizeof now);
    first->known = true;
    for (int i = 0; i < STATE_COUNT; i++)
        if (memcmp(now[i], first->values[i], sizeof now[i]) != 0)
            check_fail("%s begins with another %s", where, states[i].text);
}

static void draw_begin_of_frame(const Frame *frame) {
    static First first;
    (void)frame;
    // The names of the frame's own objects may differ.
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    compare(&first, "the frame");
    frame_bind(frame);
}

static void draw_target(const Frame *frame) {
    target_bind(&state.target);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_scene(frame, &frame->programs[PROGRAM_SCENE], frame_clip_from_world(frame),
               frame->scene->camera.eye);
    glUseProgram(0);
}

static void draw_picture(const Frame *frame) {
    frame_bind(frame);
    draw_scene(frame, &frame->programs[PROGRAM_SCENE], frame_clip_from_world(frame),
               frame->scene->camera.eye);
    glUseProgram(0);
}

static void draw_end_of_frame(const Frame *frame) {
    const int which = (int)frame->knobs[KNOB_STATE];
    Value before = {0}, after = {0};
    if (which < 0)
        return;
    states[which].ask(before, states[which].name, states[which].index);
    leave(which);
    if (states[which].ask != ask_condition) // which asking would end
        states[which].ask(after, states[which].name, states[which].index);
    else
        after[0] = 1;
    if (memcmp(before, after, sizeof before) == 0)
        check_fail("%s was not changed", states[which].text);
}

static bool create(const Frame *frame) {
    static First first;
    compare(&first, "create");
    return target_create(&state.target, frame->width, frame->height, GL_RGBA8, GL_DEPTH_COMPONENT24);
}

static void destroy(void) {
    target_destroy(&state.target);
}

const Lab lab = {
    .title = "States",
    .programs = {[PROGRAM_SCENE] = {"scene.vert", "unshadowed.frag", NULL}},
    .knobs = {[KNOB_STATE] = {"state", "number", -1, STATE_COUNT - 1, -1}},
    .passes = {{"begin", draw_begin_of_frame},
               {"target", draw_target},
               {"picture", draw_picture},
               {"end", draw_end_of_frame}},
    .stages = {{"target", &state.target.color}},
    .create = create,
    .destroy = destroy,
};
