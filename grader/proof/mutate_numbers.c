#include "proof/mutations.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHANGES = 7, TEXT = 64 };

// A number as a text of the same kind: 2 as "2", "2.0" or "2.0f".
static void write_number(char text[TEXT], double value, const char *model) {
    const bool whole = !strpbrk(model, ".") || strncmp(model, "0x", 2) == 0;
    const char *suffix = !whole && model[strlen(model) - 1] == 'f' ? "f" : "";
    if (whole)
        snprintf(text, TEXT, "%.0f", value);
    else
        snprintf(text, TEXT, "%.7g%s%s", value, value == (long)value ? ".0" : "", suffix);
}

static void change_number(Mutants *mutants, const Source *source, int i) {
    char model[TEXT], text[TEXT];
    snprintf(model, sizeof model, "%.*s", (int)source->pieces[i].length, source->pieces[i].text);
    const double n = strtod(model, NULL);
    const bool whole = !strpbrk(model, ".");
    const double half = whole ? trunc(n / 2) : n / 2;
    const double values[CHANGES] = {0, 1, n + 1, n - 1, 2 * n, half, -n};
    for (int k = 0; k < CHANGES; k++) {
        if (values[k] == n)
            continue;
        write_number(text, values[k], model);
        mutants_add(mutants, source, i, i,
                    text[0] == '-' && source_is_one_of(source, i - 1, "- +") ? "(%s)" : "%s", text);
    }
}

void mutations_of_numbers(Mutants *mutants, const Source *source) {
    for (int i = 0; i < source->count; i++)
        if (source->pieces[i].kind == PIECE_NUMBER)
            change_number(mutants, source, i);
}
