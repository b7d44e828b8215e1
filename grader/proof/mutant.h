// Small changes of a solution, one at a time: what a rubric must notice. A change replaces some pieces that
// stand next to each other by another text; whether the result compiles is seen later.
#pragma once

#include "proof/source.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct Mutant {
    int file;                   // which of the lab's
    size_t begin, end;          // of what is replaced, in the annotated text
    int line;                   // where that begins, from 1
    int nth;                    // of the places in that line where `before` changes, from 1
    char task[PIECE_TASK];      // whose answer it stands in
    char *before, *replacement; // on one line, with single blanks; owned
} Mutant;

typedef struct Mutants {
    Mutant *list;
    int count, room;
    int file; // that mutants_add writes into new ones
} Mutants;

// Adds the change of the pieces first to last into a text, as by printf; not when they already read so, when
// one of them belongs to no answer, or when the same change is there.
void mutants_add(Mutants *mutants, const Source *source, int first, int last, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

// The same for piece i and each of the texts, which are separated by blanks.
void mutants_add_each(Mutants *mutants, const Source *source, int i, const char *texts);

void mutants_destroy(Mutants *mutants); // accepts zeroed mutants

// The annotated text with the change. Freed by the caller.
char *mutant_apply(const Mutant *mutant, const char *text);

// The text of pieces first to last on one line, with single blanks. Freed by the caller.
char *mutant_quote(const Source *source, int first, int last);
