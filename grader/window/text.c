// Bakes the letters of a font into a texture and draws all text of a frame in one call.
#include "window/text.h"

#include "scene/check.h"
#include "scene/count.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

enum { ATLAS = 1024, WHITE = 3, MAX_FONT = 1 << 24 };

struct TextVertex {
    float x, y, u, v;
    Color color;
};

static FILE *open_font(void) {
    static const char *const paths[] = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",        // Debian, Ubuntu
        "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf", // Fedora
        "/usr/share/fonts/TTF/DejaVuSansMono.ttf",                    // Arch
        "/System/Library/Fonts/Menlo.ttc",                            // macOS
        "/System/Library/Fonts/Supplemental/Courier New.ttf",
    };
    for (unsigned i = 0; i < COUNT(paths); i++) {
        FILE *file = fopen(paths[i], "rb");
        if (file)
            return file;
    }
    check_fail("there is no font for the window: install DejaVu Sans Mono (common/setup does)");
    return NULL;
}

// The font's bytes, freed by the caller.
static unsigned char *read_font(void) {
    FILE *file = open_font();
    unsigned char *bytes = file ? calloc(MAX_FONT, 1) : NULL;
    size_t size = bytes ? fread(bytes, 1, MAX_FONT, file) : 0;
    if (file)
        fclose(file);
    if (size > 0)
        return bytes;
    free(bytes);
    return NULL;
}

// The height near `height` at which a letter is a whole number of pixels wide: letters stay sharp.
static float sharp_height(const stbtt_fontinfo *font, float height) {
    int advance, bearing;
    stbtt_GetCodepointHMetrics(font, 'M', &advance, &bearing);
    float width = (float)advance * stbtt_ScaleForPixelHeight(font, height);
    return height * fmaxf(1, roundf(width)) / width;
}

static void set_metrics(Text *text, const stbtt_fontinfo *font, float height) {
    int ascent, descent, gap, advance, bearing;
    float scale = stbtt_ScaleForPixelHeight(font, height);
    stbtt_GetFontVMetrics(font, &ascent, &descent, &gap);
    stbtt_GetCodepointHMetrics(font, 'M', &advance, &bearing);
    text->advance = roundf((float)advance * scale);
    text->ascent = roundf((float)ascent * scale);
    text->line = roundf(1.25F * height);
}

static void set_glyph(Glyph *glyph, const stbtt_bakedchar *baked) {
    glyph->left = baked->xoff;
    glyph->top = baked->yoff;
    glyph->right = baked->xoff + (float)(baked->x1 - baked->x0);
    glyph->bottom = baked->yoff + (float)(baked->y1 - baked->y0);
    glyph->u0 = (float)baked->x0 / ATLAS;
    glyph->v0 = (float)baked->y0 / ATLAS;
    glyph->u1 = (float)baked->x1 / ATLAS;
    glyph->v1 = (float)baked->y1 / ATLAS;
}

static void upload(Text *text, unsigned char *pixels) {
    for (int y = ATLAS - WHITE; y < ATLAS; y++)
        memset(pixels + (size_t)y * ATLAS + ATLAS - WHITE, 255, WHITE);
    text->u_white = text->v_white = 1 - WHITE / 2.0F / ATLAS;
    glGenTextures(1, &text->texture);
    glBindTexture(GL_TEXTURE_2D, text->texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, ATLAS, ATLAS, 0, GL_RED, GL_UNSIGNED_BYTE, pixels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

static bool bake(Text *text, unsigned char *font, float height) {
    stbtt_fontinfo info;
    static stbtt_bakedchar baked[TEXT_COUNT];
    unsigned char *pixels = calloc(ATLAS, ATLAS);
    bool ok = pixels && stbtt_InitFont(&info, font, stbtt_GetFontOffsetForIndex(font, 0));
    if (ok) {
        height = sharp_height(&info, height);
        set_metrics(text, &info, height);
        ok = stbtt_BakeFontBitmap(font, stbtt_GetFontOffsetForIndex(font, 0), height, pixels, ATLAS, ATLAS,
                                  TEXT_FIRST, TEXT_COUNT, baked) > 0;
    }
    for (int i = 0; ok && i < TEXT_COUNT; i++)
        set_glyph(&text->glyphs[i], &baked[i]);
    if (ok)
        upload(text, pixels);
    free(pixels);
    return ok || check_fail("the window's font cannot be drawn");
}

static void create_array(Text *text) {
    const GLsizei stride = sizeof(struct TextVertex);
    glGenVertexArrays(1, &text->array);
    glGenBuffers(1, &text->buffer);
    glBindVertexArray(text->array);
    glBindBuffer(GL_ARRAY_BUFFER, text->buffer);
    for (GLuint i = 0; i < 3; i++)
        glEnableVertexAttribArray(i);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, (void *)offsetof(struct TextVertex, x));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, (void *)offsetof(struct TextVertex, u));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                          (void *)offsetof(struct TextVertex, color));
}

bool text_create(Text *text, float height) {
    memset(text, 0, sizeof *text);
    unsigned char *font = read_font();
    bool ok = font && bake(text, font, height) &&
              program_create(&text->program, &(ProgramFiles){"text.vert", "text.frag", NULL});
    free(font);
    if (ok)
        create_array(text);
    else
        text_destroy(text);
    return ok;
}

void text_destroy(Text *text) {
    program_destroy(&text->program);
    if (text->texture)
        glDeleteTextures(1, &text->texture);
    if (text->array)
        glDeleteVertexArrays(1, &text->array);
    if (text->buffer)
        glDeleteBuffers(1, &text->buffer);
    free(text->vertices);
    memset(text, 0, sizeof *text);
}

static void add_quad(Text *text, const Glyph *at, Color color) {
    if (text->count + 6 > text->room) {
        text->room = 2 * text->room + 6000;
        text->vertices = realloc(text->vertices, (size_t)text->room * sizeof *text->vertices);
        INVARIANT(text->vertices);
    }
    const struct TextVertex corners[4] = {{at->left, at->top, at->u0, at->v0, color},
                                          {at->right, at->top, at->u1, at->v0, color},
                                          {at->right, at->bottom, at->u1, at->v1, color},
                                          {at->left, at->bottom, at->u0, at->v1, color}};
    const int order[6] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < 6; i++)
        text->vertices[text->count++] = corners[order[i]];
}

float text_put(Text *text, float x, float y, Color color, const char *string) {
    float base = roundf(y) + text->ascent;
    for (const char *at = string; *at; at++) {
        int index = (*at < TEXT_FIRST || *at >= TEXT_FIRST + TEXT_COUNT ? '?' : *at) - TEXT_FIRST;
        float pen = roundf(x) + (float)(at - string) * text->advance;
        Glyph placed = text->glyphs[index];
        placed.left += pen;
        placed.right += pen;
        placed.top += base;
        placed.bottom += base;
        add_quad(text, &placed, color);
    }
    return (float)strlen(string) * text->advance;
}

void text_box(Text *text, float x, float y, float width, float height, Color color) {
    add_quad(
        text,
        &(Glyph){x, y, x + width, y + height, text->u_white, text->v_white, text->u_white, text->v_white},
        color);
}

void text_draw(Text *text, int width, int height) {
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    program_set_vec3(&text->program, "u_window_size", vec3_make((float)width, (float)height, 0));
    program_set_texture(&text->program, "u_font", 0, GL_TEXTURE_2D, text->texture);
    glUseProgram(text->program.id);
    glBindVertexArray(text->array);
    glBindBuffer(GL_ARRAY_BUFFER, text->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)text->count * sizeof *text->vertices), text->vertices,
                 GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, text->count);
    glDisable(GL_BLEND);
    text->count = 0;
}
