// Cuts the text into tokens, hashes each run of them, and keeps the smallest hash of each window.
#include "copies/fingerprint.h"

#include "base/hash.h"
#include "scene/check.h"
#include "scene/count.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct TokenList {
    uint64_t *tokens; // hashes
    int count;
    uint64_t named; // of the tokens as they stand
} TokenList;

// Words that are no names: they say what the code does.
static bool is_keyword(const char *word, size_t length) {
    static const char *const words[] = {"if",
                                        "else",
                                        "for",
                                        "while",
                                        "do",
                                        "switch",
                                        "case",
                                        "default",
                                        "break",
                                        "continue",
                                        "return",
                                        "discard",
                                        "struct",
                                        "const",
                                        "static",
                                        "void",
                                        "int",
                                        "uint",
                                        "float",
                                        "double",
                                        "bool",
                                        "char",
                                        "true",
                                        "false",
                                        "in",
                                        "out",
                                        "inout",
                                        "uniform",
                                        "layout",
                                        "vec2",
                                        "vec3",
                                        "vec4",
                                        "ivec2",
                                        "ivec3",
                                        "ivec4",
                                        "mat3",
                                        "mat4",
                                        "sizeof",
                                        "unsigned",
                                        "enum",
                                        "texture",
                                        "dot",
                                        "cross",
                                        "normalize",
                                        "min",
                                        "max",
                                        "clamp",
                                        "mix",
                                        "step",
                                        "smoothstep",
                                        "length",
                                        "sampler2D",
                                        "sampler2DShadow"};
    for (size_t i = 0; i < COUNT(words); i++)
        if (strlen(words[i]) == length && memcmp(words[i], word, length) == 0)
            return true;
    return false;
}

static const char *after_comment(const char *at) {
    if (at[1] == '/')
        return at + strcspn(at, "\n");
    const char *end = strstr(at + 2, "*/");
    return end ? end + 2 : at + strlen(at);
}

static const char *after_string(const char *at) {
    const char quote = *at++;
    while (*at && *at != quote && *at != '\n')
        at += at[0] == '\\' && at[1] ? 2 : 1;
    return *at == quote ? at + 1 : at;
}

static bool is_word(char c) {
    return isalnum((unsigned char)c) || c == '_' || (unsigned char)c >= 0x80;
}

// The end of the token that begins at `at`, and the hash of what it says.
static const char *take_token(const char *at, uint64_t *hash) {
    const char *end = at;
    if (*at == '"' || *at == '\'') {
        *hash = hash_bytes(HASH_START, "\"", 1);
        return after_string(at);
    }
    const bool number = isdigit((unsigned char)at[0]) || (at[0] == '.' && isdigit((unsigned char)at[1]));
    while (is_word(*end) || (number && *end == '.'))
        end++;
    if (end == at)
        end++;
    const bool name = !number && is_word(*at) && !is_keyword(at, (size_t)(end - at));
    *hash = name ? hash_bytes(HASH_START, "name", 4) : hash_bytes(HASH_START, at, (size_t)(end - at));
    return end;
}

static TokenList cut(const char *text) {
    TokenList list = {calloc(strlen(text) + 1, sizeof *list.tokens), 0, HASH_START};
    INVARIANT(list.tokens);
    while (*text) {
        const char *begin = text;
        if (isspace((unsigned char)*text) || *text == '\\') {
            text++;
        } else if (text[0] == '/' && (text[1] == '/' || text[1] == '*')) {
            text = after_comment(text);
        } else {
            text = take_token(text, &list.tokens[list.count++]);
            list.named = hash_bytes(hash_bytes(list.named, begin, (size_t)(text - begin)), "", 1);
        }
    }
    return list;
}

static int by_value(const void *a, const void *b) {
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return x < y ? -1 : x > y;
}

static void sort_once(CodePrint *fingerprint) {
    int kept = 0;
    qsort(fingerprint->hashes, (size_t)fingerprint->count, sizeof *fingerprint->hashes, by_value);
    for (int i = 0; i < fingerprint->count; i++)
        if (kept == 0 || fingerprint->hashes[i] != fingerprint->hashes[kept - 1])
            fingerprint->hashes[kept++] = fingerprint->hashes[i];
    fingerprint->count = kept;
}

static bool holds(const CodePrint *given, uint64_t hash) {
    return given && given->count > 0 &&
           bsearch(&hash, given->hashes, (size_t)given->count, sizeof hash, by_value) != NULL;
}

// The hashes of all grams that are not given.
static CodePrint grams(const char *text, const CodePrint *given) {
    TokenList list = cut(text);
    CodePrint all = {hash_bytes(HASH_START, list.tokens, sizeof *list.tokens * (size_t)list.count),
                     list.named, calloc((size_t)list.count + 1, sizeof *all.hashes), 0};
    INVARIANT(all.hashes);
    for (int i = 0; i + FINGERPRINT_GRAM <= list.count; i++) {
        const uint64_t hash = hash_bytes(HASH_START, list.tokens + i, sizeof *list.tokens * FINGERPRINT_GRAM);
        if (!holds(given, hash))
            all.hashes[all.count++] = hash;
    }
    free(list.tokens);
    return all;
}

CodePrint fingerprint_of_given(const char *text) {
    CodePrint all = grams(text, NULL);
    sort_once(&all);
    return all;
}

CodePrint fingerprint_make(const char *text, const CodePrint *given) {
    CodePrint all = grams(text, given);
    int kept = 0;
    for (int i = 0; i < all.count; i++) {
        uint64_t least = all.hashes[i];
        for (int j = i + 1; j < all.count && j < i + FINGERPRINT_WINDOW; j++)
            least = all.hashes[j] < least ? all.hashes[j] : least;
        all.hashes[kept++] = least; // at most i + 1 are written, and none before i is read again
    }
    all.count = kept;
    sort_once(&all);
    return all;
}

void fingerprint_destroy(CodePrint *fingerprint) {
    free(fingerprint->hashes);
    *fingerprint = (CodePrint){0};
}

int fingerprint_common(const CodePrint *a, const CodePrint *b) {
    int common = 0;
    for (int i = 0, j = 0; i < a->count && j < b->count;) {
        common += a->hashes[i] == b->hashes[j];
        const bool first = a->hashes[i] <= b->hashes[j], second = b->hashes[j] <= a->hashes[i];
        i += first;
        j += second;
    }
    return common;
}
