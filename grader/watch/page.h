// Lines of text with a style, wrapped at words, and shown so that they fit the terminal.
#pragma once

#include <stdbool.h>
#include <stdio.h>

enum { PAGE_LINES = 160, PAGE_WIDTH = 320, PAGE_MARK = 8 };

typedef enum Style { STYLE_PLAIN, STYLE_GOOD, STYLE_BAD, STYLE_BOLD, STYLE_DIM } Style;

typedef struct PageLine {
    Style mark_style, style;
    char mark[PAGE_MARK]; // stands before the text
    char text[PAGE_WIDTH];
} PageLine;

typedef struct Page {
    int columns, count;
    PageLine lines[PAGE_LINES];
} Page;

void page_begin(Page *page, int columns); // columns: where text is wrapped

// Adds one line, which is cut where the page ends. Lines that have no room on the page are dropped.
void page_line(Page *page, Style style, const char *format, ...) __attribute__((format(printf, 3, 4)));

// The same behind a mark of at most 7 characters that has a style of its own.
void page_marked(Page *page, Style mark_style, const char *mark, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// Adds a text of any length: broken at its line ends and at words, indented by `indent`.
void page_text(Page *page, Style style, int indent, const char *text);

// "[####......]" with `width` places between the brackets; share is 0..1.
void page_bar(char *text, size_t size, double share, int width);

// Writes the whole page, line by line, with the colours of a terminal when `color`.
void page_print(const Page *page, FILE *out, bool color);

// Fills the screen: the page from the top (what does not fit is cut, and the last line says so), `footer` in
// the last row.
void page_show(const Page *page, const char *footer, int columns, int rows, bool color);
