// Builds an HTML page that needs no other file and no network.
#pragma once

#include "scene/image.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct Page {
    FILE *out; // for markup of our own; everything else goes through page_text
    char *text;
    size_t size;
} Page;

// Writes shell.html up to its content: the title, escaped, and the style of base.css and of the file `style`
// of the project ("grader/pages/page.css"). False with a message.
bool page_begin_shell(FILE *out, const char *title, const char *style);

// Writes what comes behind the content. False with a message.
bool page_end_shell(FILE *out);

// Around markup that tells points, so that a page can be given without them.
#define PAGE_POINTS "<!--points-->"
#define PAGE_POINTS_END "<!--/points-->"

// Begins a page up to its heading, with the style of page.css. False with a message.
bool page_begin(Page *page, const char *title);

// Ends the page with the scripts of compare.js and page.js; the caller frees the text. NULL with a message.
char *page_end(Page *page);

// Writes text, escaped for element content and for attributes in double quotes.
void page_text(Page *page, const char *text);

// The same for a sentence: what stands between two backticks is shown as code.
void page_prose(Page *page, const char *text);

// Begins a table that can be scrolled by itself on a narrow screen. `label` says what it holds; `heads` are
// the columns' heads, NULL after the last: with a '#' before it, that of a column of numbers; "": of none;
// "#points" is marked as points. Rows follow, then page_end_table.
void page_begin_table(Page *page, const char *label, const char *const *heads);
void page_end_table(Page *page);

// Writes a cell of text.
void page_cell(Page *page, const char *text);

// Writes a data: URI with the bytes; `type` is "image/png".
void page_data(Page *page, const char *type, const void *bytes, size_t size);

// Writes an <img> with the picture as a data: URI. `description` is its alt text.
void page_picture(Page *page, const Image *image, const char *class_name, const char *description);

// Writes the bytes in base64 (RFC 4648), padded.
void page_base64(FILE *out, const uint8_t *bytes, size_t size);
