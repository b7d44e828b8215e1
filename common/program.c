// Compiles and links the files of a program, with messages that name the shader's file and line, and finds
// uniforms by name: one that no shader mentions is a fault, one that the compiler left out is none.
#include "program.h"

#include "remark.h"
#include "scene/check.h"
#include "scene/shader_source.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { LOG_BYTES = 2000 };

static bool report_compile_error(GLuint shader, const ShaderSource *source) {
    char log[LOG_BYTES] = "", mapped[LOG_BYTES + 400];
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    shader_source_map_log(source, log, mapped, sizeof mapped);
    return check_fail("%s does not compile:\n%s", source->files[0], mapped);
}

static bool attach(GLuint program, GLenum stage, const char *name) {
    ShaderSource source;
    if (!shader_source_load(&source, name))
        return false;
    GLuint shader = glCreateShader(stage);
    GLint compiled = GL_FALSE;
    glShaderSource(shader, 1, (const GLchar *const *)&source.text, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    bool ok = compiled || report_compile_error(shader, &source);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    shader_source_destroy(&source);
    return ok;
}

static bool link_program(GLuint id, const ProgramFiles *files) {
    GLint linked = GL_FALSE;
    char log[LOG_BYTES] = "";
    glLinkProgram(id);
    glGetProgramiv(id, GL_LINK_STATUS, &linked);
    if (linked)
        return true;
    glGetProgramInfoLog(id, sizeof log, NULL, log);
    return check_fail("%s and %s do not link:\n%s", files->vertex, files->fragment, log);
}

bool program_create(Program *program, const ProgramFiles *files) {
    *program = (Program){.id = glCreateProgram(), .files = *files};
    if (attach(program->id, GL_VERTEX_SHADER, files->vertex) &&
        (!files->geometry || attach(program->id, GL_GEOMETRY_SHADER, files->geometry)) &&
        attach(program->id, GL_FRAGMENT_SHADER, files->fragment) && link_program(program->id, files))
        return true;
    program_destroy(program);
    return false;
}

void program_destroy(Program *program) {
    if (program->id)
        glDeleteProgram(program->id);
    *program = (Program){0};
}

// Does the word stand in the text, not only as a part of longer words?
static bool has_word(const char *text, const char *word) {
    const size_t length = strlen(word);
    for (const char *at = strstr(text, word); at; at = strstr(at + 1, word)) {
        const char before = at > text ? at[-1] : ' ', after = at[length];
        if (!isalnum((unsigned char)before) && before != '_' && !isalnum((unsigned char)after) &&
            after != '_')
            return true;
    }
    return false;
}

// Does the name up to its first '[' or '.' stand in the text of a shader?
static bool stands_in(GLuint shader, const char *name) {
    GLint length = 0;
    glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
    char *text = calloc((size_t)length + 1, 1), word[128];
    if (!text)
        return true;
    glGetShaderSource(shader, length, NULL, text);
    strncpy(word, name, sizeof word - 1);
    word[sizeof word - 1] = '\0';
    word[strcspn(word, "[.")] = '\0';
    bool found = has_word(text, word);
    free(text);
    return found;
}

static bool require_name(const Program *program, const char *name) {
    GLuint shaders[3];
    GLsizei count = 0;
    glGetAttachedShaders(program->id, 3, &count, shaders);
    for (GLsizei i = 0; i < count; i++)
        if (stands_in(shaders[i], name))
            return true;
    return check_fail(
        "the uniform %s is set but declared neither in %s nor in %s: declare it or correct its name", name,
        program->files.vertex, program->files.fragment);
}

GLint program_find(const Program *program, const char *name) {
    return glGetUniformLocation(program->id, name);
}

static GLint find(const Program *program, const char *name) {
    GLint location = program_find(program, name);
    if (location < 0 && require_name(program, name))
        remark_idle_uniform(name);
    return location;
}

void program_set_mat4(const Program *program, const char *name, mat4s value) {
    glProgramUniformMatrix4fv(program->id, find(program, name), 1, GL_FALSE, &value.raw[0][0]);
}

void program_set_vec3(const Program *program, const char *name, vec3s value) {
    glProgramUniform3fv(program->id, find(program, name), 1, value.raw);
}

void program_set_vec4s(const Program *program, const char *name, const vec4s *values, int count) {
    glProgramUniform4fv(program->id, find(program, name), count, values[0].raw);
}

void program_set_float(const Program *program, const char *name, float value) {
    glProgramUniform1f(program->id, find(program, name), value);
}

void program_set_int(const Program *program, const char *name, int value) {
    glProgramUniform1i(program->id, find(program, name), value);
}

void program_set_texture(const Program *program, const char *name, int unit, GLenum target, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(target, texture);
    glActiveTexture(GL_TEXTURE0);
    program_set_int(program, name, unit);
}
