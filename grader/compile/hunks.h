// Where two versions of a function read otherwise. No compiler, no files.
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { HUNKS_MAX = 40, HUNKS_MOST_WORDS = 1000 };

// A text, and where in it the function stands.
typedef struct TextPart {
    const char *text;
    size_t begin, end;
} TextPart;

// Our words from number `first` to before `end` (0 is the function's first) are left out, or, where there are
// none, other words are put in before `first`.
typedef struct Hunk {
    int first, end;
    int first_line, last_line; // of them in our text, from 1; of words that are put in: of both neighbours
} Hunk;

typedef struct Hunks {
    Hunk list[HUNKS_MAX];
    int count;
    bool unknown; // there are too many, or too many words
} Hunks;

// What has to be left out of `ours` and put in to make `theirs`, with the fewest words. Blanks and comments
// do not count.
void hunks_find(Hunks *hunks, TextPart theirs, TextPart ours);

// Do both versions differ from ours in the same place? True where one is not known.
bool hunks_meet(const Hunks *a, const Hunks *b);
