// Letters of one fixed-width font and boxes, over the window's picture. Needs a context.
#pragma once

#include "program.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct Color {
    uint8_t r, g, b, a;
} Color;

typedef struct Glyph {
    float left, top, right, bottom; // pixels, from the pen on the base line, y downwards
    float u0, v0, u1, v1;           // in the font's texture
} Glyph;

enum { TEXT_FIRST = 32, TEXT_COUNT = 95 };

typedef struct Text {
    Program program;
    GLuint texture, buffer, array;
    Glyph glyphs[TEXT_COUNT];
    float u_white, v_white;      // a texel that is wholly covered, for boxes
    float advance, line, ascent; // pixels
    struct TextVertex *vertices; // owned
    int count, room;
} Text;

// Reads the font (DejaVu Sans Mono, or the system's own) and draws its letters `height` pixels high. False
// with a message when there is none.
bool text_create(Text *text, float height);
void text_destroy(Text *text); // accepts a zeroed text

// Puts a string, with its upper left corner at (x, y) in pixels; a character that is not ASCII shows as '?'.
// Returns its width in pixels.
float text_put(Text *text, float x, float y, Color color, const char *string);

// A filled rectangle, under what is put after it.
void text_box(Text *text, float x, float y, float width, float height, Color color);

// Draws what was put, over the current framebuffer of this size, and forgets it.
void text_draw(Text *text, int width, int height);
