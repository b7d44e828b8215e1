// Shader files: #include is resolved, and what the compiler says is mapped back to file:line:column. No GL.
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { SHADER_MAX_FILES = 16, SHADER_MAX_NAME = 64 };

typedef struct ShaderSource {
    char *text; // one string for glShaderSource, owned
    size_t length;
    char files[SHADER_MAX_FILES][SHADER_MAX_NAME]; // source-string number -> file name
    int file_count;
} ShaderSource;

// Where shader files are looked for: the lab's folder first, then the shared one. The
// strings are kept, not copied.
void shader_source_folders(const char *lab_folder, const char *shared_folder);

// Reads `name` with its includes. The file begins with "#version 410 core"; `#include "name"` takes a plain
// file name and each file once. The text carries #line, so that line numbers stay true.
bool shader_source_load(ShaderSource *source, const char *name);
void shader_source_destroy(ShaderSource *source); // accepts a zeroed source

// Writes `log` to `text` with Mesa's "SOURCE:LINE(COLUMN): " turned into "FILE:LINE:COLUMN: ".
void shader_source_map_log(const ShaderSource *source, const char *log, char *text, size_t size);
