#include "proof/mutations.h"

#include <stdlib.h>

// Behind these a statement begins; a ")" ends the head of an if or a loop, or a cast or a call, which a
// statement does not follow.
static bool begins_statement(const Source *source, int i) {
    if (source_is_one_of(source, i - 1, "; { } else"))
        return true;
    if (!source_is(source, i - 1, ")") || source->pieces[i - 1].partner < 1)
        return false;
    return source_is_one_of(source, source->pieces[i - 1].partner - 1, "if for while");
}

static bool is_declaration(const Source *source, int i) {
    return source_is_one_of(source, i, "const static struct enum typedef uniform in out subroutine layout") ||
           (source_is_type(source, i) && !source_is(source, i + 1, "("));
}

// Is it between the parentheses of a for?
static bool is_in_head(const Source *source, int i) {
    for (int k = i - 1; k > 0 && !source_is_one_of(source, k, "{ }"); k--)
        if (source_is(source, k, "(") && source->pieces[k].partner > i)
            return true;
    return false;
}

static void drop(Mutants *mutants, const Source *source, int i) {
    if (!source->pieces[i].task[0] || !begins_statement(source, i) || is_declaration(source, i) ||
        source_is_one_of(source, i, "if for while do switch else return case default ; { }") ||
        is_in_head(source, i))
        return;
    const int end = source_find(source, i, ";");
    if (end > i)
        mutants_add(mutants, source, i, end, ";");
}

static void change_condition(Mutants *mutants, const Source *source, int i) {
    if (!source_is(source, i, "if") || !source_is(source, i + 1, "("))
        return;
    const int first = i + 2, last = source->pieces[i + 1].partner - 1;
    if (last < first)
        return;
    char *text = mutant_quote(source, first, last);
    mutants_add(mutants, source, first, last, "true");
    mutants_add(mutants, source, first, last, "false");
    mutants_add(mutants, source, first, last, "!(%s)", text);
    free(text);
}

void mutations_of_statements(Mutants *mutants, const Source *source) {
    for (int i = 0; i < source->count; i++) {
        drop(mutants, source, i);
        change_condition(mutants, source, i);
    }
}
