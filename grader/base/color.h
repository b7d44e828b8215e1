// Whether what a program prints may be in colour, and the colours, for all programs.
#pragma once

#include <stdbool.h>
#include <stdio.h>

// Is `out` a terminal that knows colours, and does nobody forbid them by NO_COLOR (no-color.org: set, and not
// empty)?
bool color_wanted(FILE *out);

// Is it said of the terminal (TERM=dumb) that it only goes on line by line, as a shell in an editor?
bool color_is_dumb(void);

typedef enum ColorUse { COLOR_PLAIN, COLOR_GOOD, COLOR_BAD, COLOR_NOTE, COLOR_BOLD, COLOR_DIM } ColorUse;

// Ends what color_begin began.
#define COLOR_END "\033[0m"

// What is printed before a text of this use; "" for COLOR_PLAIN. Nobody tells whether a terminal is light or
// dark, so the colours are half as bright as white: of 256 where the terminal has so many (color_has_many),
// else those of its own that are not pale on either; a note is bold then.
const char *color_begin(ColorUse use);

// Does the terminal say (TERM, COLORTERM) that it has 256 colours?
bool color_has_many(void);
