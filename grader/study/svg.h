// Lines, marks and letters as SVG. Text is escaped; letters have no font of their own.
#pragma once

#include "study/chart_layout.h"

#include <stdio.h>

enum { SVG_CROSS = -1 };

typedef struct Svg {
    FILE *body;
    char *text; // of the body, owned
    size_t size;
    int width, height; // once ended
} Svg;

// False with a message when there is no memory.
bool svg_begin(Svg *svg);
void svg_end(Svg *svg, int width, int height);

// Writes the ended picture to a file and frees it. False with a message.
bool svg_write(Svg *svg, const char *path);

// `dash` as SVG has it ("7 4"); NULL: none.
void svg_line(Svg *svg, double x1, double y1, double x2, double y2, const char *color, double width,
              const char *dash);
void svg_box(Svg *svg, LayoutBox box, const char *color);
void svg_ring(Svg *svg, double x, double y, double radius, const char *color);

// Circle, square, triangles, diamond: five filled, five open, and so on; SVG_CROSS: a cross.
void svg_mark(Svg *svg, double x, double y, double radius, int shape, const char *color);

// `anchor`: start, middle or end; y is the letters' foot.
void svg_text(Svg *svg, double x, double y, int size, const char *anchor, const char *color,
              const char *format, ...) __attribute__((format(printf, 7, 8)));

// What follows, up to svg_end_titled, shows this text under the mouse.
void svg_begin_titled(Svg *svg, const char *format, ...) __attribute__((format(printf, 2, 3)));
void svg_end_titled(Svg *svg);
