#include "book/name_key.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_FOLDED = 0xc0, FIRST_MARK = 0x300, LAST_MARK = 0x36f, MAX_WORDS = 16 };

// Of U+00C0 to U+017F the base letters; ' ' for what is no letter.
static const char bases[] = "aaaaaaaceeeeiiiidnooooo ouuuuytsaaaaaaaceeeeiiiidnooooo ouuuuyty"
                            "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllll"
                            "nnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";

static unsigned decode(const char **at) {
    const unsigned char *bytes = (const unsigned char *)*at;
    const int length = bytes[0] >= 0xf0 ? 4 : bytes[0] >= 0xe0 ? 3 : bytes[0] >= 0xc0 ? 2 : 1;
    unsigned code = length == 1 ? bytes[0] : bytes[0] & (0x7fu >> length);
    for (int i = 1; i < length; i++) {
        if (bytes[i] >> 6 != 2) { // no UTF-8: the byte by itself
            *at += 1;
            return bytes[0];
        }
        code = code << 6 | (bytes[i] & 0x3f);
    }
    *at += length;
    return code;
}

// Writes what is left of the next character: nothing, a space between words, or its letter.
static int fold(char to[8], const char **at) {
    const char *from = *at;
    const unsigned code = decode(at);
    if ((code >= FIRST_MARK && code <= LAST_MARK) || code == '\'' || code == 0x2019)
        return 0;
    if (code >= FIRST_FOLDED && code < FIRST_FOLDED + sizeof bases - 1)
        to[0] = bases[code - FIRST_FOLDED];
    else if (code < FIRST_FOLDED)
        to[0] = (char)(code < 0x80 && isalnum((int)code) ? tolower((int)code) : ' ');
    else
        return (int)(memcpy(to, from, (size_t)(*at - from)), *at - from);
    return 1;
}

static void fold_all(char key[NAME_KEY], size_t length, const char *name) {
    char letter[8];
    while (*name) {
        const int size = fold(letter, &name);
        if (length + (size_t)size >= NAME_KEY)
            break;
        memcpy(key + length, letter, (size_t)size);
        length += (size_t)size;
    }
    key[length] = '\0';
}

static int by_text(const void *a, const void *b) {
    return strcmp(*(char *const *)a, *(char *const *)b);
}

void name_key_words(char key[NAME_KEY], const char *name) {
    char folded[NAME_KEY], *words[MAX_WORDS], *rest = folded;
    int count = 0, length = 0;
    fold_all(folded, 0, name);
    for (char *word; count < MAX_WORDS && (word = strtok_r(rest, " ", &rest));)
        words[count++] = word;
    qsort(words, (size_t)count, sizeof words[0], by_text);
    key[0] = '\0';
    for (int i = 0; i < count; i++)
        length += snprintf(key + length, (size_t)(NAME_KEY - length), "%s%s", i > 0 ? " " : "", words[i]);
}

void name_key_joined(char key[NAME_KEY], const char *first, const char *second) {
    size_t length = 0;
    fold_all(key, 0, first);
    fold_all(key, strlen(key), second);
    for (const char *at = key; *at; at++)
        if (*at != ' ')
            key[length++] = *at;
    key[length] = '\0';
}
