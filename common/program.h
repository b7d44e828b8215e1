// Shader programs and their uniforms.
#pragma once

#include "gl.h"
#include "scene/mathx.h"

#include <stdbool.h>

// The files of one program, looked for in the lab's folder, then in shaders/. `geometry` may be NULL.
typedef struct ProgramFiles {
    const char *vertex, *fragment, *geometry;
} ProgramFiles;

typedef struct Program {
    GLuint id;
    ProgramFiles files;
} Program;

// Compiles and links. The message of a compile error holds FILE:LINE:COLUMN lines and the raw log.
bool program_create(Program *program, const ProgramFiles *files);
void program_destroy(Program *program); // accepts a zeroed program

// Sets a uniform of the program, which need not be in use; which one is does not change. A name that stands
// in none of the program's shaders is an error of the lab (see check_message); one that the compiler removed
// because it has no effect is not.
void program_set_mat4(const Program *program, const char *name, mat4s value);
void program_set_vec3(const Program *program, const char *name, vec3s value);
void program_set_vec4s(const Program *program, const char *name, const vec4s *values, int count); // an array
void program_set_float(const Program *program, const char *name, float value);
void program_set_int(const Program *program, const char *name, int value);

// Binds `texture` of `target` (GL_TEXTURE_2D, ...) to texture unit `unit` and points
// the sampler `name` to it.
void program_set_texture(const Program *program, const char *name, int unit, GLenum target, GLuint texture);

// Location of a uniform that the program may do without, -1 when it is not there.
GLint program_find(const Program *program, const char *name);
