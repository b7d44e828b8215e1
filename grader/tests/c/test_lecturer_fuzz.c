// The lecturers' files of all labs, mutated 10,000 times from a printed seed: none crashes a reader, and each
// refusal has a message that names the file. SHADOW_LAB_FUZZ=SEED takes another seed, SHADOW_LAB_FUZZ_COUNT=N
// another number.
#include "base/files.h"
#include "base/places.h"
#include "compile/rubric_file.h"
#include "compile/rubric_fit.h"
#include "scene/check.h"
#include "scene/count.h"
#include "scene/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char *const names[RUBRIC_FILES] = {"rubric.json", "mistakes.json", "alternatives.json",
                                                "hints.json"};

static const Description nothing;

typedef struct Original {
    char *folder, *texts[RUBRIC_FILES];
} Original;

typedef struct Originals {
    Original labs[COURSE_MAX_LABS];
    int count;
} Originals;

static void take_lab(const char *id, void *context) {
    Originals *originals = context;
    char folder[FILES_PATH], path[FILES_PATH];
    assert_true(originals->count < COURSE_MAX_LABS && places_find_lab(folder, id));
    Original *original = &originals->labs[originals->count++];
    original->folder = strdup(folder);
    for (int i = 0; i < RUBRIC_FILES; i++) {
        files_join(path, folder, names[i]);
        original->texts[i] = files_read(path, RUBRIC_MAX_FILE);
        assert_non_null(original->texts[i]);
    }
}

// What may stand in the place of a value.
static const char *const strange[] = {"null",
                                      "true",
                                      "-1",
                                      "0",
                                      "60",
                                      "2147483648",
                                      "-9223372036854775808",
                                      "99999999999999999999",
                                      "1e308",
                                      "-1e-308",
                                      "1e999",
                                      "NaN",
                                      "\"\"",
                                      "\"..\"",
                                      "\"\\u0000\"",
                                      "\"\\ud800\"",
                                      "\"\xc3\x28\"",
                                      "[]",
                                      "{}",
                                      "[[]]",
                                      "{\"\": {}}",
                                      "\"../x.c\"",
                                      "[\"a\", 1]"};

static int below(Random *random, size_t count) {
    return (int)(random_next(random) % (count ? count : 1));
}

// The end of the JSON value that begins at `at`, roughly: for strings, numbers, and lists without strings of
// brackets.
static size_t value_end(const char *text, size_t at) {
    int depth = 0;
    for (bool quoted = false; text[at]; at++) {
        if (text[at] == '"' && (at == 0 || text[at - 1] != '\\'))
            quoted = !quoted;
        else if (!quoted && strchr("[{", text[at]))
            depth++;
        else if (!quoted && strchr("]}", text[at]) && --depth < 0)
            return at;
        else if (!quoted && depth == 0 && text[at] == ',')
            return at;
    }
    return at;
}

// A place where a value begins: behind a ':', ',', '[' or '{'.
static size_t value_begin(const char *text, size_t length, Random *random) {
    size_t at = (size_t)below(random, length);
    at += strcspn(text + at, ":,[{");
    return text[at] ? at + 1 : length;
}

static size_t splice(char *to, const char *text, size_t at, size_t end, const char *between) {
    return (size_t)sprintf(to, "%.*s%s%s", (int)at, text, between, text + end);
}

// Mutates `text` into `to`, which has room for twice as much and some more.
static void mutate(char *to, const char *text, Random *random) {
    const size_t length = strlen(text), at = value_begin(text, length, random), end = value_end(text, at);
    switch (below(random, 7)) {
    case 0: // flipped bytes
        strcpy(to, text);
        for (int i = below(random, 4); i >= 0 && length; i--)
            to[below(random, length)] ^= (char)(1 << below(random, 8));
        return;
    case 1: // cut off
        splice(to, text, (size_t)below(random, length + 1), length, "");
        return;
    case 2: // a value, key or entry is removed
        splice(to, text, at, end, "");
        return;
    case 3: // is there twice
        sprintf(to, "%.*s,%s", (int)end, text, text + at);
        return;
    case 4: { // is nested deeply
        char deep[4200];
        const int depth = 1 << below(random, 12);
        memset(deep, "[{"[below(random, 2)], (size_t)depth);
        deep[depth] = '\0';
        splice(to, text, at, at, deep);
        return;
    }
    case 5: { // gets a byte of any value
        const char byte[2] = {(char)(1 + below(random, 255)), '\0'};
        splice(to, text, (size_t)below(random, length + 1), length, "");
        strcat(to, byte);
        strcat(to, text + strlen(to) - 1);
        return;
    }
    default: // is of another type or size
        splice(to, text, at, end, strange[below(random, COUNT(strange))]);
    }
}

// The mutated file beside good ones; true when it is refused.
static bool refused(const Original *original, int file, const char *text) {
    const char *texts[RUBRIC_FILES] = {original->texts[RUBRIC_JSON], "[]", original->texts[ALTERNATIVES_JSON],
                                       "{}"};
    Rubric rubric;
    texts[file] = text;
    check_clear();
    if (rubric_read(&rubric, original->folder, texts)) {
        rubric_fit_lab(&rubric, &nothing);
        rubric_destroy(&rubric);
        return false;
    }
    if (!strstr(check_message(), names[file]))
        fail_msg("a message without %s: %s\n%s", names[file], check_message(), text);
    return true;
}

static void test_mutations(void **unused) {
    static Originals originals;
    const char *seed = getenv("SHADOW_LAB_FUZZ"), *wanted = getenv("SHADOW_LAB_FUZZ_COUNT");
    Random random = {seed ? strtoull(seed, NULL, 10) : 20261126};
    const int count = wanted ? atoi(wanted) : 10000;
    int refusals_seen = 0;
    (void)unused;
    printf("SHADOW_LAB_FUZZ=%llu, %d mutated files\n", (unsigned long long)random.state, count);
    check_clear();
    assert_true(places_list_labs(take_lab, &originals) && originals.count > 0);
    for (int i = 0; i < count; i++) {
        const Original *original = &originals.labs[below(&random, (size_t)originals.count)];
        const int file = below(&random, RUBRIC_FILES);
        char *text = malloc(2 * strlen(original->texts[file]) + 8192);
        assert_non_null(text);
        mutate(text, original->texts[file], &random);
        refusals_seen += refused(original, file, text);
        free(text);
    }
    printf("%d of them refused\n", refusals_seen);
    assert_true(refusals_seen > count / 2 && refusals_seen < count);
    for (int i = 0; i < originals.count; i++) {
        free(originals.labs[i].folder);
        for (int file = 0; file < RUBRIC_FILES; file++)
            free(originals.labs[i].texts[file]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_mutations)};
    return cmocka_run_group_tests_name("lecturers' files, mutated", tests, NULL, NULL);
}
