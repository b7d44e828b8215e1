#include "remark.h"

#include "scene/check.h"
#include "scene/count.h"

#include <string.h>

static char text[1000];
static bool in_passes;

void remark_clear(void) {
    text[0] = '\0';
    in_passes = false;
}

void remark_passes(bool run) {
    in_passes = run;
}

static void add(const char *line) {
    if (!strstr(text, line))
        check_append(text, sizeof text, "%s%s", text[0] ? "\n" : "", line);
}

void remark_call(const char *name) {
    static const struct {
        const char *call, *what;
    } makers[] = {
        {"glGenTextures", "a texture"},
        {"glGenFramebuffers", "a framebuffer"},
        {"glGenRenderbuffers", "a renderbuffer"},
        {"glCreateProgram", "a program"},
        {"glTexImage2D", "a texture's storage"},
        {"glTexImage3D", "a texture's storage"},
        {"glGenBuffers", "a buffer"},
        {"glGenVertexArrays", "a vertex array"},
        {"glGenSamplers", "a sampler"},
        {"glGenQueries", "a query"},
    };
    char line[200] = "";
    if (!in_passes)
        return;
    for (size_t i = 0; i < COUNT(makers); i++)
        if (strcmp(name, makers[i].call) == 0) {
            check_append(line, sizeof line, "each frame makes %s anew (%s): once, in create, is enough",
                         makers[i].what, name);
            add(line);
        }
}

void remark_idle_uniform(const char *name) {
    char line[200] = "";
    check_append(line, sizeof line,
                 "the uniform %.60s is set, but has no effect: what stands in its place, a number?", name);
    add(line);
}

const char *remark_text(void) {
    return text;
}
