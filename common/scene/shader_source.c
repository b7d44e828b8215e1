// Reads a shader file and, in the place of each #include, that file; keeps #line marks, by which it turns the
// numbers in the compiler's messages into names of files.
#include "scene/shader_source.h"

#include "scene/check.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SHADER_BYTES = 1 << 20, MAX_DEPTH = 8 };

static const char *folders[2] = {".", "shaders"};

void shader_source_folders(const char *lab_folder, const char *shared_folder) {
    folders[0] = lab_folder;
    folders[1] = shared_folder;
}

static char *read_stream(FILE *file) {
    char *text = malloc(MAX_SHADER_BYTES + 1);
    if (text) {
        size_t length = fread(text, 1, MAX_SHADER_BYTES, file);
        text[length] = '\0';
    }
    fclose(file);
    return text;
}

static char *read_shader(const char *name) {
    static const char *const parts[] = {"", "/given", ""};
    for (int i = 0; i < 3; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s%s/%s", folders[i / 2], parts[i], name);
        FILE *file = fopen(path, "r");
        if (file)
            return read_stream(file);
    }
    check_fail("%s: there is no such shader file in the lab's folder or in shaders/", name);
    return NULL;
}

static bool append(ShaderSource *source, const char *text, size_t length) {
    char *grown = realloc(source->text, source->length + length + 1);
    if (!grown)
        return check_fail("out of memory for a shader of %zu bytes", source->length + length);
    memcpy(grown + source->length, text, length);
    source->length += length;
    grown[source->length] = '\0';
    source->text = grown;
    return true;
}

static bool append_line_mark(ShaderSource *source, int line, int file) {
    char mark[64];
    int length = snprintf(mark, sizeof mark, "#line %d %d\n", line, file);
    return append(source, mark, (size_t)length);
}

// The name in `#include "name"`, or false when the line is no include. Bad ones give an empty name.
static bool parse_include(const char *line, char *name) {
    while (*line == ' ' || *line == '\t')
        line++;
    if (strncmp(line, "#include", 8) != 0)
        return false;
    const char *open = line + 8 + strspn(line + 8, " \t");
    size_t length = *open == '"' ? strcspn(open + 1, "\"\n") : 0;
    bool plain = length > 0 && length < SHADER_MAX_NAME && open[1 + length] == '"' && open[1] != '.';
    for (size_t i = 0; plain && i < length; i++)
        plain = isalnum((unsigned char)open[1 + i]) || strchr("_-.", open[1 + i]);
    snprintf(name, SHADER_MAX_NAME, "%.*s", plain ? (int)length : 0, open + 1);
    return true;
}

static bool append_file(ShaderSource *source, const char *name, int depth);

static bool append_include(ShaderSource *source, const char *name, int line, int file, int depth) {
    if (name[0] == '\0')
        return check_fail("%s:%d: #include takes one plain file name in quotes", source->files[file], line);
    for (int i = 0; i < source->file_count; i++)
        if (strcmp(source->files[i], name) == 0)
            return append_line_mark(source, line + 1, file);
    return append_file(source, name, depth + 1) && append_line_mark(source, line + 1, file);
}

static bool append_lines(ShaderSource *source, const char *text, int file, int depth) {
    char name[SHADER_MAX_NAME];
    for (int line = 1; *text; line++) {
        size_t length = strcspn(text, "\n");
        bool ended = text[length] == '\n';
        bool ok = parse_include(text, name) ? append_include(source, name, line, file, depth)
                                            : append(source, text, length) && append(source, "\n", 1);
        if (!ok)
            return false;
        text += length + (ended ? 1 : 0);
    }
    return true;
}

static bool append_file(ShaderSource *source, const char *name, int depth) {
    if (source->file_count == SHADER_MAX_FILES || depth == MAX_DEPTH)
        return check_fail("%s: too many #includes", name);
    int file = source->file_count++;
    snprintf(source->files[file], SHADER_MAX_NAME, "%s", name);
    char *text = read_shader(name);
    const bool marked = text && strncmp(text, "\xef\xbb\xbf", 3) == 0; // as some editors begin a file, unseen
    const char *begin = marked ? text + 3 : text;
    bool ok = text && (file == 0 || append_line_mark(source, 1, file));
    if (ok && file == 0 && strncmp(begin, "#version 410 core", 17) != 0)
        ok = check_fail("%s:1: the first line must be: #version 410 core", name);
    ok = ok && append_lines(source, begin, file, depth);
    free(text);
    return ok;
}

bool shader_source_load(ShaderSource *source, const char *name) {
    *source = (ShaderSource){0};
    if (append_file(source, name, 0))
        return true;
    shader_source_destroy(source);
    return false;
}

void shader_source_destroy(ShaderSource *source) {
    free(source->text);
    source->text = NULL;
}

void shader_source_map_log(const ShaderSource *source, const char *log, char *text, size_t size) {
    text[0] = '\0';
    while (*log) {
        int file, line, column, used = 0;
        size_t length = strcspn(log, "\n");
        if (sscanf(log, "%d:%d(%d): %n", &file, &line, &column, &used) == 3 && used > 0 && file >= 0 &&
            file < source->file_count)
            check_append(text, size, "%s:%d:%d: ", source->files[file], line, column);
        else
            used = 0;
        check_append(text, size, "%.*s\n", (int)length - used, log + used);
        log += length + (log[length] == '\n');
    }
}
