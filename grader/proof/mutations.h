// The kinds of small changes.
#pragma once

#include "proof/mutant.h"

// Adds all changes of the answers in the source, kind after kind. Each of the others adds its kind.
void mutations_list(Mutants *mutants, const Source *source);

// A number n becomes 0, 1, n + 1, n - 1, 2 n, n / 2 and -n.
void mutations_of_numbers(Mutants *mutants, const Source *source);

// An operator becomes another one with the same operands; signs and negations go; ++ becomes --; of a | b
// either side stays alone; the letters of a swizzle change.
void mutations_of_operators(Mutants *mutants, const Source *source);

// A name becomes another one that stands for the same kind of thing: constants of GL, of an enum of the file,
// functions and fields that come in pairs.
void mutations_of_names(Mutants *mutants, const Source *source);

// A variable, parameter or field that the file declares becomes another one of its type, or gets a sign.
void mutations_of_variables(Mutants *mutants, const Source *source);

// A statement goes; a condition becomes always true, never true, and its contrary.
void mutations_of_statements(Mutants *mutants, const Source *source);

// The first two arguments of a call change places; a call becomes one of its first two arguments; a cast
// goes.
void mutations_of_calls(Mutants *mutants, const Source *source);
