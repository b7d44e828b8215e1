#include "proof/mutations.h"

#include "scene/count.h"

#include <stdio.h>
#include <string.h>

// Names that may stand in each other's place: GL constants, calls that come in pairs, fields of a scene.
static const char *const groups[] = {
    "GL_NEAREST GL_LINEAR GL_NEAREST_MIPMAP_NEAREST GL_LINEAR_MIPMAP_LINEAR",
    "GL_REPEAT GL_MIRRORED_REPEAT GL_CLAMP_TO_EDGE GL_CLAMP_TO_BORDER",
    "GL_TEXTURE_WRAP_S GL_TEXTURE_WRAP_T GL_TEXTURE_WRAP_R",
    "GL_TEXTURE_MIN_FILTER GL_TEXTURE_MAG_FILTER",
    "GL_COMPARE_REF_TO_TEXTURE GL_NONE",
    "GL_NEVER GL_LESS GL_EQUAL GL_LEQUAL GL_GREATER GL_NOTEQUAL GL_GEQUAL GL_ALWAYS",
    "GL_KEEP GL_ZERO GL_REPLACE GL_INCR GL_INCR_WRAP GL_DECR GL_DECR_WRAP GL_INVERT",
    "GL_FRONT GL_BACK GL_FRONT_AND_BACK",
    "GL_RGBA8 GL_RGB8 GL_R8 GL_RGBA16F GL_RGBA32F",
    "GL_R32F GL_R16F GL_R8 GL_RG32F GL_RGBA32F",
    "GL_DEPTH_COMPONENT16 GL_DEPTH_COMPONENT24 GL_DEPTH_COMPONENT32F GL_DEPTH24_STENCIL8",
    "GL_RGBA GL_RGB GL_RED GL_BGRA GL_DEPTH_COMPONENT",
    "GL_UNSIGNED_BYTE GL_FLOAT GL_INT",
    "GL_TEXTURE_2D GL_TEXTURE_3D",
    "GL_FRAMEBUFFER GL_DRAW_FRAMEBUFFER GL_READ_FRAMEBUFFER",
    "GL_COLOR_ATTACHMENT0 GL_COLOR_ATTACHMENT1 GL_DEPTH_ATTACHMENT GL_DEPTH_STENCIL_ATTACHMENT",
    "GL_NONE GL_COLOR_ATTACHMENT0 GL_BACK",
    "GL_COLOR_BUFFER_BIT GL_DEPTH_BUFFER_BIT GL_STENCIL_BUFFER_BIT",
    "GL_COLOR GL_DEPTH GL_STENCIL",
    "GL_DEPTH_TEST GL_STENCIL_TEST GL_BLEND GL_CULL_FACE GL_POLYGON_OFFSET_FILL GL_SCISSOR_TEST",
    "GL_ONE GL_ZERO GL_SRC_COLOR GL_DST_COLOR GL_SRC_ALPHA GL_ONE_MINUS_SRC_ALPHA",
    "GL_TRUE GL_FALSE",
    "true false",
    "GL_FRAGMENT_SHADER GL_VERTEX_SHADER GL_GEOMETRY_SHADER",
    "LIGHT_SPOT LIGHT_DIRECTIONAL",
    "glEnable glDisable",
    "sinf cosf tanf",
    "sin cos tan",
    "sqrtf fabsf",
    "sqrt abs",
    "min max",
    "floor ceil round",
    "near_plane far_plane",
    "width height",
    "columns rows",
    "left bottom right up",
    "position target",
    "eye target",
};

// The other names in the same enum as piece i, when the file has one.
static void exchange_in_enums(Mutants *mutants, const Source *source, int i, int open) {
    const int close = source->pieces[open].partner;
    bool member = false;
    for (int k = open + 1; k < close; k++)
        member =
            member ||
            (source->pieces[k].kind == PIECE_NAME && source->pieces[k].length == source->pieces[i].length &&
             memcmp(source->pieces[k].text, source->pieces[i].text, source->pieces[i].length) == 0);
    for (int k = open + 1; member && k < close; k++)
        if (source->pieces[k].kind == PIECE_NAME && source_is_one_of(source, k - 1, "{ ,"))
            mutants_add(mutants, source, i, i, "%.*s", (int)source->pieces[k].length, source->pieces[k].text);
}

void mutations_of_names(Mutants *mutants, const Source *source) {
    for (int i = 0; i < source->count; i++) {
        if (source->pieces[i].kind != PIECE_NAME || !source->pieces[i].task[0])
            continue;
        for (size_t k = 0; k < COUNT(groups); k++)
            if (source_is_one_of(source, i, groups[k]))
                mutants_add_each(mutants, source, i, groups[k]);
        for (int k = 0; k + 1 < source->count; k++)
            if (source_is(source, k, "enum") && source_is(source, k + 1, "{") &&
                source->pieces[k + 1].partner > 0)
                exchange_in_enums(mutants, source, i, k + 1);
    }
}
