#include "base/color.h"

#include "scene/count.h"

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

bool color_has_many(void) {
    static const char *const known[] = {"256color", "direct", "kitty", "alacritty", "foot", "ghostty"};
    const char *terminal = getenv("TERM"), *more = getenv("COLORTERM");
    bool many = more && more[0];
    for (size_t i = 0; i < COUNT(known); i++)
        many = many || (terminal && strstr(terminal, known[i]));
    return many;
}

const char *color_begin(ColorUse use) {
    static const char *const codes[2][COLOR_DIM + 1] = {
        {"", "\033[32m", "\033[31m", "\033[1m", "\033[1m", "\033[2m"},
        {"", "\033[38;5;28m", "\033[38;5;196m", "\033[38;5;130m", "\033[1m", "\033[2m"}};
    return codes[color_has_many()][use];
}
