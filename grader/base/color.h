// Whether what a program prints may be in colour.
#pragma once

#include <stdbool.h>
#include <stdio.h>

// Is `out` a terminal that knows colours, and does nobody forbid them by NO_COLOR (no-color.org: set, and not
// empty)?
bool color_wanted(FILE *out);

// Is it said of the terminal (TERM=dumb) that it only goes on line by line, as a shell in an editor?
bool color_is_dumb(void);
