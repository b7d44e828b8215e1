// Writes SVG piece by piece into memory, then as a file.
#include "study/svg.h"

#include "base/files.h"
#include "scene/check.h"

#include <stdarg.h>
#include <stdlib.h>

bool svg_begin(Svg *svg) {
    *svg = (Svg){0};
    svg->body = open_memstream(&svg->text, &svg->size);
    return svg->body || check_fail("out of memory for a picture");
}

void svg_end(Svg *svg, int width, int height) {
    svg->width = width;
    svg->height = height;
}

bool svg_write(Svg *svg, const char *path) {
    bool ok = fclose(svg->body) == 0;
    char *whole = NULL;
    size_t size;
    FILE *file = ok ? open_memstream(&whole, &size) : NULL;
    if (file)
        fprintf(file,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
                "font-family=\"sans-serif\">\n<rect width=\"100%%\" height=\"100%%\" "
                "fill=\"#ffffff\"/>\n%s</svg>\n",
                svg->width, svg->height, svg->width, svg->height, svg->text);
    ok = file && fclose(file) == 0;
    free(svg->text);
    *svg = (Svg){0};
    ok = ok ? files_write_whole(path, whole, true) : check_fail("out of memory for %s", path);
    free(whole);
    return ok;
}

static void escape(FILE *file, const char *text) {
    for (; *text; text++)
        if (*text == '<' || *text == '&' || *text == '>')
            fprintf(file, "&#%d;", *text);
        else
            fputc(*text, file);
}

static void escape_all(FILE *file, const char *format, va_list arguments) {
    char text[256];
    vsnprintf(text, sizeof text, format, arguments);
    escape(file, text);
}

void svg_line(Svg *svg, double x1, double y1, double x2, double y2, const char *color, double width,
              const char *dash) {
    fprintf(svg->body,
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"%g\"", x1, y1,
            x2, y2, color, width);
    if (dash)
        fprintf(svg->body, " stroke-dasharray=\"%s\"", dash);
    fputs("/>\n", svg->body);
}

void svg_box(Svg *svg, LayoutBox box, const char *color) {
    fprintf(svg->body, "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"none\" stroke=\"%s\"/>\n",
            box.left, box.top, box.right - box.left, box.bottom - box.top, color);
}

void svg_ring(Svg *svg, double x, double y, double radius, const char *color) {
    fprintf(svg->body,
            "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%g\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\"/>\n", x,
            y, radius, color);
}

void svg_mark(Svg *svg, double x, double y, double radius, int shape, const char *color) {
    static const double corners[][4][2] = {{{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}},
                                           {{0, -1.2}, {1.1, .8}, {-1.1, .8}, {0, -1.2}},
                                           {{0, 1.2}, {1.1, -.8}, {-1.1, -.8}, {0, 1.2}},
                                           {{0, -1.3}, {1.1, 0}, {0, 1.3}, {-1.1, 0}}};
    const char *fill = shape / 5 % 2 ? "#ffffff" : color;
    if (shape == SVG_CROSS) {
        svg_line(svg, x - radius, y - radius, x + radius, y + radius, color, 3, NULL);
        svg_line(svg, x - radius, y + radius, x + radius, y - radius, color, 3, NULL);
    } else if (shape % 5 == 0) {
        fprintf(svg->body,
                "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%g\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.8\"/>\n",
                x, y, radius - 1, fill, color);
    } else {
        fputs("<polygon points=\"", svg->body);
        for (int c = 0; c < 4; c++)
            fprintf(svg->body, "%.1f,%.1f ", x + (radius - 1) * corners[shape % 5 - 1][c][0],
                    y + (radius - 1) * corners[shape % 5 - 1][c][1]);
        fprintf(svg->body, "\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.8\"/>\n", fill, color);
    }
}

void svg_text(Svg *svg, double x, double y, int size, const char *anchor, const char *color,
              const char *format, ...) {
    va_list arguments;
    fprintf(svg->body,
            "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%d\" text-anchor=\"%s\" fill=\"%s\" "
            "paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"3\">",
            x, y, size, anchor, color);
    va_start(arguments, format);
    escape_all(svg->body, format, arguments);
    va_end(arguments);
    fputs("</text>\n", svg->body);
}

void svg_begin_titled(Svg *svg, const char *format, ...) {
    va_list arguments;
    fputs("<g><title>", svg->body);
    va_start(arguments, format);
    escape_all(svg->body, format, arguments);
    va_end(arguments);
    fputs("</title>\n", svg->body);
}

void svg_end_titled(Svg *svg) {
    fputs("</g>\n", svg->body);
}
