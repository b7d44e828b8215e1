#include "proof/mutations.h"

#include "scene/count.h"

#include <stdio.h>
#include <string.h>

// Operators, and what takes the same operands.
static const struct {
    const char *from, *to;
} groups[] = {{"+ - * /", "+ - * /"},   {"%", "/ *"},      {"< <= > >= == !=", "< <= > >= == !="},
              {"&& ||", "&& ||"},       {"& |", "& |"},    {"<< >>", "<< >>"},
              {"+= -= *=", "+= -= *="}, {"++ --", "++ --"}};

// Is it an operator between two operands? In "Light *light" it belongs to a type.
static bool is_binary(const Source *source, int i) {
    return source_ends_operand(source, i - 1);
}

static void change_operator(Mutants *mutants, const Source *source, int i) {
    const bool steps = source_is_one_of(source, i, "++ --");
    for (size_t k = 0; k < COUNT(groups); k++)
        if (source_is_one_of(source, i, groups[k].from) && (steps || is_binary(source, i)))
            mutants_add_each(mutants, source, i, groups[k].to);
    if (source_is_one_of(source, i, "- !") && !is_binary(source, i))
        mutants_add(mutants, source, i, i, "%s", "");
}

// Bits of GL are joined by |: each side is tried alone.
static void split_bits(Mutants *mutants, const Source *source, int i) {
    if (!source_is(source, i, "|") || i == 0 || source->pieces[i - 1].kind != PIECE_NAME ||
        i + 1 >= source->count || source->pieces[i + 1].kind != PIECE_NAME)
        return;
    for (int side = i - 1; side <= i + 1; side += 2)
        mutants_add(mutants, source, i - 1, i + 1, "%.*s", (int)source->pieces[side].length,
                    source->pieces[side].text);
}

static const char *swizzle_set(const Piece *piece) {
    static const char *const sets[] = {"xyzw", "rgba", "stpq"};
    for (size_t k = 0; k < COUNT(sets) && piece->length <= 4; k++)
        if (strspn(piece->text, sets[k]) == piece->length)
            return sets[k];
    return NULL;
}

static void change_swizzle(Mutants *mutants, const Source *source, int i) {
    const Piece *piece = &source->pieces[i];
    const char *set = source_is(source, i - 1, ".") && piece->kind == PIECE_NAME ? swizzle_set(piece) : NULL;
    const size_t length = piece->length;
    if (!set)
        return;
    for (int k = 0; length == 1 && k < (source->c ? 3 : 4); k++)
        mutants_add(mutants, source, i, i, "%c", set[k]);
    if (length == 1)
        return;
    char turned[5] = "", moved[5] = "", same[5] = "";
    for (size_t k = 0; k < length; k++) {
        turned[k] = piece->text[length - 1 - k];
        moved[k] = set[(strchr(set, piece->text[k]) - set + 1) % 4];
        same[k] = piece->text[0];
    }
    mutants_add(mutants, source, i, i, "%s", turned);
    mutants_add(mutants, source, i, i, "%s", moved);
    mutants_add(mutants, source, i, i, "%s", same);
}

void mutations_of_operators(Mutants *mutants, const Source *source) {
    for (int i = 0; i < source->count; i++) {
        if (source->pieces[i].kind == PIECE_MARK)
            change_operator(mutants, source, i);
        split_bits(mutants, source, i);
        change_swizzle(mutants, source, i);
    }
}
