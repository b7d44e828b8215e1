#include "proof/mutations.h"

#include <stdlib.h>
#include <string.h>

typedef struct Argument {
    int first, last; // pieces
} Argument;

// The first two arguments of the call whose "(" is piece `open`; returns how many there are, at most 2.
static int find_arguments(const Source *source, int open, Argument arguments[2]) {
    const int close = source->pieces[open].partner;
    if (close <= open + 1)
        return 0;
    const int comma = source_find(source, open + 1, ",");
    arguments[0] = (Argument){open + 1, comma < 0 ? close - 1 : comma - 1};
    if (comma < 0)
        return 1;
    const int second = source_find(source, comma + 1, ",");
    arguments[1] = (Argument){comma + 1, second < 0 ? close - 1 : second - 1};
    return 2;
}

static void exchange_arguments(Mutants *mutants, const Source *source, const Argument arguments[2]) {
    char *a = mutant_quote(source, arguments[0].first, arguments[0].last);
    char *b = mutant_quote(source, arguments[1].first, arguments[1].last);
    mutants_add(mutants, source, arguments[0].first, arguments[1].last, "%s, %s", b, a);
    free(a);
    free(b);
}

// Calls of GL give nothing that an argument could stand for, and a constructor's argument is of another type.
static bool gives_a_value(const Source *source, int i) {
    return !source_is_type(source, i) && strncmp(source->pieces[i].text, "gl", 2) != 0 &&
           !source_is_one_of(source, i - 1, "; { }");
}

static void change_call(Mutants *mutants, const Source *source, int i) {
    Argument arguments[2];
    const int count = find_arguments(source, i + 1, arguments);
    if (count == 2 &&
        !source_is_one_of(source, i, "dot min max distance glms_vec3_add")) // these do not mind the order
        exchange_arguments(mutants, source, arguments);
    for (int k = 0; k < count && gives_a_value(source, i); k++) {
        char *text = mutant_quote(source, arguments[k].first, arguments[k].last);
        mutants_add(mutants, source, i, source->pieces[i + 1].partner, "(%s)", text);
        free(text);
    }
}

static bool is_cast(const Source *source, int i) {
    return source->c && source_is(source, i, "(") && source_is_type(source, i + 1) &&
           source_is(source, i + 2, ")") && !source_is(source, i + 3, "{") && i > 0 &&
           source->pieces[i - 1].kind == PIECE_MARK;
}

void mutations_of_calls(Mutants *mutants, const Source *source) {
    for (int i = 0; i + 1 < source->count; i++) {
        const bool named = source->pieces[i].kind == PIECE_NAME && source->pieces[i].task[0] &&
                           !source_is_one_of(source, i, "if for while switch return layout subroutine");
        const bool declares = source_is_type(source, i - 1);
        if (named && !declares && source_is(source, i + 1, "(") && source->pieces[i + 1].partner > 0)
            change_call(mutants, source, i);
        if (is_cast(source, i))
            mutants_add(mutants, source, i, i + 2, "%s", "");
    }
}
