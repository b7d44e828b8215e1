#include "book/plain_number.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

// "1.23457E+11", also with a comma.
static bool is_rounded(const char *text) {
    const size_t whole = strspn(text, "0123456789"),
                 dot = whole > 0 && (text[whole] == '.' || text[whole] == ',');
    const char *power = text + whole + dot + strspn(text + whole + dot, "0123456789");
    return whole > 0 && toupper((unsigned char)power[0]) == 'E' && power[1] == '+' && power[2] &&
           !power[2 + strspn(power + 2, "0123456789")];
}

static void drop_envelope(char *text) {
    const size_t length = strlen(text);
    if (length < 3 || strncmp(text, "=\"", 2) != 0 || text[length - 1] != '"')
        return;
    memmove(text, text + 2, length - 3);
    text[length - 3] = '\0';
}

// The bytes of a space at `text`, also of one that does not break; 0: it is none.
static size_t space(const char *text) {
    static const char *const spaces[] = {" ", "\u00a0", "\u202f"};
    for (size_t i = 0; i < sizeof spaces / sizeof spaces[0]; i++)
        if (strncmp(text, spaces[i], strlen(spaces[i])) == 0)
            return strlen(spaces[i]);
    return 0;
}

static bool is_digits_and_spaces(const char *text) {
    while (*text && (isdigit((unsigned char)*text) || space(text) > 0))
        text += space(text) > 0 ? space(text) : 1;
    return !*text;
}

static void drop_spaces(char *text) {
    char *to = text;
    while (*text) {
        const size_t bytes = space(text);
        text += bytes;
        if (bytes == 0)
            *to++ = *text++;
    }
    *to = '\0';
}

static void drop_fraction(char *text) {
    const size_t whole = strspn(text, "0123456789");
    if (whole > 0 && (strcmp(text + whole, ".0") == 0 || strcmp(text + whole, ",0") == 0))
        text[whole] = '\0';
}

bool plain_number(char *number, size_t size, const char *cell) {
    snprintf(number, size, "%s", cell);
    drop_envelope(number);
    if (is_digits_and_spaces(number))
        drop_spaces(number);
    drop_fraction(number);
    return !is_rounded(number);
}
