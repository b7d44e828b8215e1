// Lines of coloured text that are put together on one dark ground.
#pragma once

#include "window/text.h"

#include <stddef.h>

enum { LINES_MAX = 48, LINES_LENGTH = 256 };

typedef struct Lines {
    char of[LINES_MAX][LINES_LENGTH];
    Color colors[LINES_MAX];
    int count, columns; // wrapped at `columns`; 0: not
    size_t longest;
} Lines;

// Adds a text: one line for each of its own, broken where it is longer than the columns; nothing for "". What
// has no room is left out.
void lines_add(Lines *lines, Color color, const char *text);

// The height of all of them with their ground, pixels.
float lines_height(const Lines *lines, const Text *text);

// The area of their ground, pixels.
float lines_area(const Lines *lines, const Text *text);

void lines_clear(Lines *lines); // keeps the columns

// Where there are more than `most` (at least 1), the last ones give way to `instead`.
void lines_keep(Lines *lines, int most, Color color, const char *instead);

// Puts them with the upper left corner of their ground at (x, y) pixels.
void lines_put(const Lines *lines, Text *text, float x, float y, Color ground);
