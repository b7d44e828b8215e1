#include "base/color.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool color_is_dumb(void) {
    const char *terminal = getenv("TERM");
    return terminal && strcmp(terminal, "dumb") == 0;
}

bool color_wanted(FILE *out) {
    const char *forbidden = getenv("NO_COLOR");
    return isatty(fileno(out)) && !color_is_dumb() && !(forbidden && forbidden[0]);
}
