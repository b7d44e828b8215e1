// Lines of text with a style, wrapped at words, and shown so that they fit the terminal.
#pragma once

#include "base/color.h"

#include <stdbool.h>
#include <stdio.h>

enum { SHEET_LINES = 320, SHEET_WIDTH = 320, SHEET_MARK = 8 };

typedef enum Style {
    STYLE_PLAIN = COLOR_PLAIN,
    STYLE_GOOD = COLOR_GOOD,
    STYLE_BAD = COLOR_BAD,
    STYLE_NOTE = COLOR_NOTE,
    STYLE_BOLD = COLOR_BOLD,
    STYLE_DIM = COLOR_DIM
} Style;

typedef struct PageLine {
    Style mark_style, style;
    char mark[SHEET_MARK]; // stands before the text
    char text[SHEET_WIDTH];
} PageLine;

typedef struct Sheet {
    int columns, count;
    PageLine lines[SHEET_LINES];
} Sheet;

void sheet_begin(Sheet *sheet, int columns); // columns: where text is wrapped

// Adds one line, which is cut where the sheet ends. Lines that have no room on the sheet are dropped.
void sheet_line(Sheet *sheet, Style style, const char *format, ...) __attribute__((format(printf, 3, 4)));

// The same behind a mark of at most 7 characters that has a style of its own.
void sheet_marked(Sheet *sheet, Style mark_style, const char *mark, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// Adds a text of any length: broken at its line ends and at words, indented by `indent`. A line that
// begins with a dash goes on below its words.
void sheet_text(Sheet *sheet, Style style, int indent, const char *text);

// The same of a format, of at most SHEET_WIDTH - 1 bytes.
void sheet_wrapped(Sheet *sheet, Style style, int indent, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// "[####......]" with `width` places between the brackets; share is 0..1.
void sheet_bar(char *text, size_t size, double share, int width);

// Writes the whole sheet, line by line, with the colours of a terminal when `color`.
void sheet_print(const Sheet *sheet, FILE *out, bool color);

// How far down a sheet can be scrolled on a screen of so many rows: 0 when all of it fits.
int sheet_last_top(const Sheet *sheet, int rows);

// From which line on `line` is seen on a screen of so many rows: from `top`, if it is, else from the nearest.
int sheet_top_with(const Sheet *sheet, int line, int top, int rows);

// Fills the screen: the sheet from line `top` on (0 to sheet_last_top; when more follows, the last line says
// so), `footer` in the last row.
void sheet_show(const Sheet *sheet, int top, const char *footer, int columns, int rows, bool color);
