#include "window/lines.h"

#include <stdio.h>
#include <string.h>

// How much of the text goes into the next line: up to its end, or to the last space before the columns are
// full.
static size_t piece(const char *text, size_t columns) {
    size_t length = strcspn(text, "\n");
    if (length <= columns)
        return length;
    for (size_t i = columns; i > columns / 2; i--)
        if (text[i] == ' ')
            return i;
    return columns;
}

static void add_one(Lines *lines, Color color, const char *text, size_t length) {
    if (lines->count == LINES_MAX)
        return;
    char *line = lines->of[lines->count];
    snprintf(line, LINES_LENGTH, "%.*s", (int)length, text);
    for (char *at = line; *at; at++)
        if (*at == '\t')
            *at = ' ';
    lines->colors[lines->count++] = color;
    lines->longest = strlen(line) > lines->longest ? strlen(line) : lines->longest;
}

void lines_add(Lines *lines, Color color, const char *text) {
    size_t columns = lines->columns > 8 ? (size_t)lines->columns : LINES_LENGTH - 1;
    while (*text) {
        size_t length = piece(text, columns);
        add_one(lines, color, text, length);
        text += length;
        text += *text == '\n' || *text == ' ';
    }
}

float lines_height(const Lines *lines, const Text *text) {
    return lines->count ? (float)lines->count * text->line + text->advance : 0;
}

float lines_area(const Lines *lines, const Text *text) {
    return ((float)lines->longest + 2) * text->advance * lines_height(lines, text);
}

void lines_clear(Lines *lines) {
    lines->count = 0;
    lines->longest = 0;
}

void lines_keep(Lines *lines, int most, Color color, const char *instead) {
    most = most > 1 ? most : 1;
    if (lines->count <= most)
        return;
    lines->count = most - 1;
    lines_add(lines, color, instead);
    lines->count = lines->count < most ? lines->count : most;
}

void lines_put(const Lines *lines, Text *text, float x, float y, Color ground) {
    float margin = text->advance;
    if (lines->count == 0)
        return;
    text_box(text, x, y, (float)lines->longest * text->advance + 2 * margin, lines_height(lines, text),
             ground);
    for (int i = 0; i < lines->count; i++)
        text_put(text, x + margin, y + margin / 2 + (float)i * text->line, lines->colors[i], lines->of[i]);
}
