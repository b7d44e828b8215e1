// What of a program stays when comments, names and layout are taken away, as a set of hashes: winnowing of
// k-grams (Schleimer, Wilkerson, Aiken: Winnowing: Local Algorithms for Document Fingerprinting, SIGMOD
// 2003). For C and GLSL.
#pragma once

#include <stddef.h>
#include <stdint.h>

enum { FINGERPRINT_GRAM = 12, FINGERPRINT_WINDOW = 6 }; // tokens; what shares 17 tokens shares a hash

typedef struct CodePrint {
    uint64_t whole;   // of all tokens, names being all alike
    uint64_t named;   // of all tokens as they stand
    uint64_t *hashes; // sorted, each once
    int count;
} CodePrint;

// Makes it of the text without the grams that `given` holds (NULL: none). Two texts that differ only in
// comments, in names that are no keywords, in spaces and line ends have the same one, but for `named`.
CodePrint fingerprint_make(const char *text, const CodePrint *given);

// All grams of the text, not only those of the windows: what is to be left out elsewhere.
CodePrint fingerprint_of_given(const char *text);
void fingerprint_destroy(CodePrint *fingerprint); // accepts a zeroed one

// How many hashes two of them share.
int fingerprint_common(const CodePrint *a, const CodePrint *b);
