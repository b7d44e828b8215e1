// Two counters of the GPU, which the shaders' texts are given (counted_shader.h), and the calls of OpenGL: a
// clear counts its texels, and what would bring pictures past the counters is noted.
#include "worker/counted.h"

#include "gl.h"
#include "scene/check.h"
#include "scene/count.h"
#include "worker/counted_shader.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Of OpenGL 4.2.
#define ATOMIC_COUNTER_BUFFER 0x92C0
#define MAX_FRAGMENT_ATOMIC_COUNTERS 0x92D6

static struct {
    int kind;
    bool lab_runs;
    GLuint buffer;
    PFNGLSHADERSOURCEPROC shader_source; // the driver's
    FrameCounts counts;
} counted;

static void note(const char *what) {
    if (!counted.counts.uncounted[0])
        snprintf(counted.counts.uncounted, sizeof counted.counts.uncounted, "%.60s", what);
}

// As one string. The caller frees it.
static char *joined(GLsizei count, const GLchar *const *strings, const GLint *lengths) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    INVARIANT(out);
    for (GLsizei i = 0; i < count; i++)
        fprintf(out, "%.*s", lengths && lengths[i] >= 0 ? lengths[i] : (int)strlen(strings[i]), strings[i]);
    fclose(out);
    return text;
}

static void GLAD_API_PTR give_source(GLuint shader, GLsizei count, const GLchar *const *strings,
                                     const GLint *lengths) {
    GLint stage = 0;
    char *text = joined(count, strings, lengths);
    glad_glGetShaderiv(shader, GL_SHADER_TYPE, &stage);
    char *made = counted_shader_text(text, stage == GL_FRAGMENT_SHADER, counted.kind == COUNTED_BLIND);
    if (!made)
        note(check_message());
    const GLchar *given = made ? made : "";
    counted.shader_source(shader, 1, &given, NULL);
    free(text);
    free(made);
}

// The texels of the texture `name`, whatever its kind, in one level, of all its layers or of one; 0 for none.
static double texture_texels(GLuint name, GLint level, bool layered) {
    static const GLenum kinds[][2] = {{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
                                      {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
                                      {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
                                      {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
                                      {GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D}};
    double texels = 0;
    for (unsigned i = 0; i < COUNT(kinds) && texels == 0; i++) {
        const bool cube = kinds[i][0] == GL_TEXTURE_CUBE_MAP;
        GLint bound = 0, sides[3] = {0};
        glad_glGetIntegerv(kinds[i][1], &bound);
        glad_glBindTexture(kinds[i][0], name);
        if (glad_glGetError() != GL_NO_ERROR)
            continue;
        for (unsigned side = 0; side < 3; side++)
            glad_glGetTexLevelParameteriv(
                cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : kinds[i][0], level,
                (const GLenum[]){GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH}[side], &sides[side]);
        glad_glBindTexture(kinds[i][0], (GLuint)bound);
        texels = (double)sides[0] * sides[1] * (layered ? sides[2] * (cube ? 6 : 1) : 1);
    }
    return texels;
}

static double renderbuffer_texels(GLuint name) {
    GLint bound = 0, width = 0, height = 0;
    glad_glGetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
    glad_glBindRenderbuffer(GL_RENDERBUFFER, name);
    glad_glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &width);
    glad_glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &height);
    glad_glBindRenderbuffer(GL_RENDERBUFFER, (GLuint)bound);
    return (double)width * height;
}

static GLint attachment(GLenum point, GLenum what) {
    GLint value = 0;
    glad_glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, point, what, &value);
    return glad_glGetError() == GL_NO_ERROR ? value : 0;
}

// Of what is bound for drawing: those of its first attachment, depth before colour.
static double target_texels(void) {
    static const GLenum points[] = {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT, GL_COLOR_ATTACHMENT0};
    double texels = 0;
    for (unsigned i = 0; i < COUNT(points) && texels == 0; i++) {
        const GLint kind = attachment(points[i], GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
        const GLuint name = kind ? (GLuint)attachment(points[i], GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) : 0;
        if (kind == GL_TEXTURE)
            texels = texture_texels(name, attachment(points[i], GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL),
                                    attachment(points[i], GL_FRAMEBUFFER_ATTACHMENT_LAYERED) == GL_TRUE);
        else if (kind == GL_RENDERBUFFER)
            texels = renderbuffer_texels(name);
    }
    return texels;
}

static void count_clear(void) {
    GLint box[4] = {0};
    const double all = target_texels();
    glad_glGetIntegerv(GL_SCISSOR_BOX, box);
    const double part = (double)box[2] * box[3];
    counted.counts.texels += glad_glIsEnabled(GL_SCISSOR_TEST) && part < all ? part : all;
}

static bool begins_with(const char *name, const char *start) {
    return strncmp(name, start, strlen(start)) == 0;
}

// Does a call of glTexImage bring texels along? They are its last argument, or lie in a buffer.
static bool brings_texels(int count, va_list arguments) {
    GLint buffer = 0;
    glad_glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &buffer);
    for (int i = 0; i < count - 1; i++)
        (void)va_arg(arguments, GLint);
    return buffer != 0 || va_arg(arguments, const void *) != NULL;
}

// What brings texels into textures without a fragment, or out of them without a read.
static void watch(const char *name, int count, va_list arguments) {
    static const char *const past[] = {"glTexSubImage", "glCompressedTex", "glCopyTex",
                                       "glCopyBuffer",  "glGetTexImage",   "glGetCompressedTex",
                                       "glReadPixels",  "glTexBuffer",     "glMapBuffer",
                                       "glBlit",        "glGenerateMipmap"};
    if (!counted.lab_runs)
        return;
    for (unsigned i = 0; i < COUNT(past); i++)
        if (begins_with(name, past[i]))
            note(name);
    if (begins_with(name, "glTexImage") && !strstr(name, "Multisample") && brings_texels(count, arguments))
        note(name);
    if (strcmp(name, "glClear") == 0 || begins_with(name, "glClearBuffer"))
        count_clear();
}

bool counted_start(int kind) {
    GLint most = 0;
    glad_glGetIntegerv(MAX_FRAGMENT_ATOMIC_COUNTERS, &most);
    if (glad_glGetError() != GL_NO_ERROR || most < 2 || !gl_finish_writes())
        return check_fail(
            "this OpenGL has no counters for shaders; OpenGL 4.2 has (install Mesa's llvmpipe)");
    counted.kind = kind;
    counted.shader_source = glad_glShaderSource;
    glad_glShaderSource = give_source;
    gl_watch(watch);
    glad_glGenBuffers(1, &counted.buffer);
    return true;
}

bool counted_is_on(void) {
    return counted.kind != COUNTED_NOT;
}

static void clear_counters(void) {
    const GLuint zeros[2] = {0};
    glad_glBindBuffer(ATOMIC_COUNTER_BUFFER, counted.buffer);
    glad_glBufferData(ATOMIC_COUNTER_BUFFER, sizeof zeros, zeros, GL_DYNAMIC_READ);
    glad_glBindBufferBase(ATOMIC_COUNTER_BUFFER, 0, counted.buffer);
}

void counted_begin(void) {
    FrameCounts *counts = &counted.counts;
    if (!counted_is_on())
        return;
    counts->counted = counted.kind; // what is uncounted stays: of a shader that was refused are all frames
    counts->taps = counts->fragments = counts->texels = 0;
    clear_counters();
}

void counted_lab(bool runs) {
    counted.lab_runs = counted_is_on() && runs;
}

void counted_collect(void) {
    GLuint found[2] = {0};
    if (!counted_is_on())
        return;
    gl_finish_writes();
    glad_glBindBuffer(ATOMIC_COUNTER_BUFFER, counted.buffer);
    glad_glGetBufferSubData(ATOMIC_COUNTER_BUFFER, 0, sizeof found, found);
    counted.counts.taps += found[0];
    counted.counts.fragments += found[1];
    clear_counters();
}

FrameCounts counted_end(void) {
    return counted.counts;
}
