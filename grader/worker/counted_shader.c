// Functions of ours stand before the shader's text, and macros give them the names of GLSL's own. The
// preprocessor so finds every read, however the text makes the name. What could undo a macro is refused.
#include "worker/counted_shader.h"

#include "scene/check.h"
#include "scene/count.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Read {
    const char *result, *name, *parameters, *read;
} Read;

// The functions of GLSL that read a texel or mix some: a call is one read. Offsets must be constants in
// GLSL's own, which a parameter is not: they are added to the place.
static const Read reads[] = {
    {"vec4", "texture", "sampler1D s, float p", "texture(s, p)"},
    {"vec4", "texture", "sampler2D s, vec2 p", "texture(s, p)"},
    {"vec4", "texture", "sampler2D s, vec2 p, float b", "texture(s, p, b)"},
    {"vec4", "texture", "sampler3D s, vec3 p", "texture(s, p)"},
    {"vec4", "texture", "samplerCube s, vec3 p", "texture(s, p)"},
    {"vec4", "texture", "sampler2DArray s, vec3 p", "texture(s, p)"},
    {"vec4", "texture", "sampler1DArray s, vec2 p", "texture(s, p)"},
    {"vec4", "texture", "samplerCubeArray s, vec4 p", "texture(s, p)"},
    {"float", "texture", "samplerCubeArrayShadow s, vec4 p, float z", "texture(s, p, z)"},
    {"float", "texture", "sampler2DShadow s, vec3 p", "texture(s, p)"},
    {"float", "texture", "samplerCubeShadow s, vec4 p", "texture(s, p)"},
    {"float", "texture", "sampler2DArrayShadow s, vec4 p", "texture(s, p)"},
    {"vec4", "textureProj", "sampler2D s, vec3 p", "textureProj(s, p)"},
    {"vec4", "textureProj", "sampler2D s, vec4 p", "textureProj(s, p)"},
    {"float", "textureProj", "sampler2DShadow s, vec4 p", "textureProj(s, p)"},
    {"vec4", "textureLod", "sampler1D s, float p, float l", "textureLod(s, p, l)"},
    {"vec4", "textureLod", "sampler2D s, vec2 p, float l", "textureLod(s, p, l)"},
    {"vec4", "textureLod", "sampler3D s, vec3 p, float l", "textureLod(s, p, l)"},
    {"vec4", "textureLod", "samplerCube s, vec3 p, float l", "textureLod(s, p, l)"},
    {"vec4", "textureLod", "sampler2DArray s, vec3 p, float l", "textureLod(s, p, l)"},
    {"float", "textureLod", "sampler2DShadow s, vec3 p, float l", "textureLod(s, p, l)"},
    {"vec4", "textureGrad", "sampler2D s, vec2 p, vec2 x, vec2 y", "textureGrad(s, p, x, y)"},
    {"float", "textureGrad", "sampler2DShadow s, vec3 p, vec2 x, vec2 y", "textureGrad(s, p, x, y)"},
    {"vec4", "textureOffset", "sampler2D s, vec2 p, ivec2 o",
     "texture(s, p + vec2(o) / vec2(textureSize(s, 0)))"},
    {"float", "textureOffset", "sampler2DShadow s, vec3 p, ivec2 o",
     "texture(s, p + vec3(vec2(o) / vec2(textureSize(s, 0)), 0.0))"},
    {"vec4", "textureProjOffset", "sampler2D s, vec3 p, ivec2 o",
     "textureProj(s, p + vec3(vec2(o) / vec2(textureSize(s, 0)) * p.z, 0.0))"},
    {"vec4", "textureProjOffset", "sampler2D s, vec4 p, ivec2 o",
     "textureProj(s, p + vec4(vec2(o) / vec2(textureSize(s, 0)) * p.w, 0.0, 0.0))"},
    {"float", "textureProjOffset", "sampler2DShadow s, vec4 p, ivec2 o",
     "textureProj(s, p + vec4(vec2(o) / vec2(textureSize(s, 0)) * p.w, 0.0, 0.0))"},
    {"vec4", "textureProjLod", "sampler2D s, vec3 p, float l", "textureProjLod(s, p, l)"},
    {"vec4", "textureLodOffset", "sampler2D s, vec2 p, float l, ivec2 o",
     "textureLod(s, p + vec2(o) / vec2(textureSize(s, int(l))), l)"},
    {"vec4", "texelFetch", "sampler1D s, int p, int l", "texelFetch(s, p, l)"},
    {"vec4", "texelFetch", "sampler2D s, ivec2 p, int l", "texelFetch(s, p, l)"},
    {"vec4", "texelFetch", "sampler3D s, ivec3 p, int l", "texelFetch(s, p, l)"},
    {"vec4", "texelFetch", "sampler2DArray s, ivec3 p, int l", "texelFetch(s, p, l)"},
    {"vec4", "texelFetch", "sampler2DMS s, ivec2 p, int i", "texelFetch(s, p, i)"},
    {"vec4", "texelFetchOffset", "sampler2D s, ivec2 p, int l, ivec2 o", "texelFetch(s, p + o, l)"},
    {"vec4", "textureGather", "sampler2D s, vec2 p", "textureGather(s, p)"},
    {"vec4", "textureGather", "sampler2D s, vec2 p, int c",
     "c == 0 ? textureGather(s, p) : c == 1 ? textureGather(s, p, 1) : c == 2 ? textureGather(s, p, 2) : "
     "textureGather(s, p, 3)"},
    {"vec4", "textureGather", "sampler2DArray s, vec3 p", "textureGather(s, p)"},
    {"vec4", "textureGather", "sampler2DShadow s, vec2 p, float z", "textureGather(s, p, z)"},
    {"vec4", "textureGather", "sampler2DArrayShadow s, vec3 p, float z", "textureGather(s, p, z)"},
    {"vec4", "textureGatherOffset", "sampler2D s, vec2 p, ivec2 o", "textureGatherOffset(s, p, o)"},
    {"vec4", "textureGatherOffset", "sampler2DShadow s, vec2 p, float z, ivec2 o",
     "textureGatherOffset(s, p, z, o)"},
};

// All of them, so that one that is not counted is no function at all.
static const char *const names[] = {"texture",
                                    "textureProj",
                                    "textureLod",
                                    "textureOffset",
                                    "texelFetch",
                                    "texelFetchOffset",
                                    "textureProjOffset",
                                    "textureLodOffset",
                                    "textureProjLod",
                                    "textureProjLodOffset",
                                    "textureGrad",
                                    "textureGradOffset",
                                    "textureProjGrad",
                                    "textureProjGradOffset",
                                    "textureGather",
                                    "textureGatherOffset",
                                    "textureGatherOffsets"};

// What only a text that is after the counters needs.
static const char *const refused[] = {"counted_", "##", "undef", "atomic", "extension", "imageLoad"};

static const char COUNTERS[] = "#extension GL_ARB_shader_atomic_counters : require\n"
                               "#extension GL_ARB_shader_image_load_store : require\n"
                               "layout(binding = 0, offset = 0) uniform atomic_uint counted_taps;\n"
                               "layout(binding = 0, offset = 4) uniform atomic_uint counted_fragments;\n";

// Where nothing of the shader decides on depth or coverage, GPUs test the depth first, and what is hidden
// costs nothing. Counters would keep them from it.
static const char EARLY[] = "layout(early_fragment_tests) in;\n";

static const char MAIN[] = "\n#undef main\n"
                           "void main() {\n    atomicCounterIncrement(counted_fragments);\n    "
                           "counted_main();\n}\n";

// A copy without comments, and with lines joined that end in a backslash. NULL when there is no memory.
static char *plain(const char *text) {
    char *copy = malloc(strlen(text) + 1), *to = copy;
    while (copy && *text) {
        if (strncmp(text, "\\\n", 2) == 0) {
            text += 2;
        } else if (strncmp(text, "\\\r\n", 3) == 0) {
            text += 3;
        } else if (strncmp(text, "//", 2) == 0) {
            text += strcspn(text, "\n");
        } else if (strncmp(text, "/*", 2) == 0) {
            const char *end = strstr(text + 2, "*/");
            text = end ? end + 2 : text + strlen(text);
            *to++ = ' ';
        } else {
            *to++ = *text++;
        }
    }
    if (copy)
        *to = '\0';
    return copy;
}

static bool is_allowed(const char *code) {
    for (unsigned i = 0; i < COUNT(refused); i++)
        if (strstr(code, refused[i]))
            return check_fail("a shader that is counted may not say \"%s\"", refused[i]);
    return true;
}

static void write_functions(FILE *out, bool blind) {
    for (unsigned i = 0; i < COUNT(reads); i++) {
        const Read *read = &reads[i];
        fprintf(out, "%s counted_%s(%s) { atomicCounterIncrement(counted_taps); return ", read->result,
                read->name, read->parameters);
        fprintf(out, blind ? "%s(1.0); }\n" : "%.0s%s; }\n", read->result, read->read);
    }
}

static void write_macros(FILE *out, bool fragment) {
    for (unsigned i = 0; i < COUNT(names); i++)
        fprintf(out,
                fragment ? "#define %s counted_%s\n" : "#define %s reads_belong_into_the_fragment_shader\n",
                names[i], names[i]);
    if (fragment)
        fputs("#define main counted_main\n", out);
}

// Behind the line "#version", which must be the first.
static void write(FILE *out, const char *text, const char *code, bool fragment, bool blind) {
    const int first = (int)strcspn(text, "\n");
    fprintf(out, "%.*s\n", first, text);
    if (fragment) {
        fputs(COUNTERS, out);
        if (!strstr(code, "discard") && !strstr(code, "gl_FragDepth"))
            fputs(EARLY, out);
        write_functions(out, blind);
    }
    write_macros(out, fragment);
    fprintf(out, "#line 2\n%s", text[first] ? text + first + 1 : "");
    if (fragment)
        fputs(MAIN, out);
}

char *counted_shader_text(const char *text, bool fragment, bool blind) {
    char *made = NULL, *code = plain(text);
    size_t size;
    FILE *out = code && is_allowed(code) ? open_memstream(&made, &size) : NULL;
    if (out) {
        write(out, text, code, fragment, blind);
        fclose(out);
    }
    free(code);
    return made;
}
