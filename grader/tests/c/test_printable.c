// Names as text and as file names.
#include "base/printable.h"
#include "scene/check.h"
#include "scene/count.h"
#include "scene/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// By hand, from the rules of printable.h and RFC 3629.
static const char *const pairs[][2] = {{"Ann Lee", "Ann Lee"},
                                       {"back\\slash", "back\\\\slash"},
                                       {"\\x0a", "\\\\x0a"},
                                       {"a\nb\tc\x7f", "a\\x0ab\\x09c\\x7f"},
                                       {"Zo\xc3\xab", "Zo\xc3\xab"},
                                       {"\xf0\x9f\x98\x80", "\xf0\x9f\x98\x80"},
                                       {"\xff\xfe", "\\xff\\xfe"},
                                       {"cut \xc3", "cut \\xc3"},
                                       {"\xc0\xaf", "\\xc0\\xaf"},                   // overlong "/"
                                       {"\xed\xa0\x80", "\\xed\\xa0\\x80"},          // a surrogate
                                       {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"}, // above U+10FFFF
                                       {"\xe2\x80\xae", "\\xe2\\x80\\xae"}, // turns the direction of text
                                       {"\xc2\x85", "\\xc2\\x85"}, // a control character of two bytes
                                       {"", ""}};

static void test_known(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(pairs); i++) {
        char *text = printable_name(pairs[i][0]), *back = printable_undo(pairs[i][1]);
        assert_string_equal(text, pairs[i][1]);
        assert_string_equal(back, pairs[i][0]);
        free(text);
        free(back);
    }
}

static void test_malformed(void **state) {
    (void)state;
    static const char *const texts[] = {"\\", "a\\", "\\x", "\\x1", "\\xg0", "\\n", "\\x00"};
    for (size_t i = 0; i < COUNT(texts); i++)
        assert_null(printable_undo(texts[i]));
}

static void random_name(Random *random, char *name, int size) {
    static const unsigned char pieces[] = {'a',  '\\', 'x',  '0',  0x80, 0xc3, 0xa9, 0xe2,
                                           0x80, 0xae, 0xf0, 0x9f, 0xff, '\n', ' '};
    int length = random_int(random, 1, size - 1);
    for (int i = 0; i < length; i++)
        name[i] = random_int(random, 0, 3) ? (char)pieces[random_int(random, 0, (int)sizeof pieces - 1)]
                                           : (char)random_int(random, 1, 255);
    name[length] = '\0';
}

static void test_random(void **state) {
    (void)state;
    const uint64_t seed = 20261125;
    Random random = {seed};
    print_message("seed %llu\n", (unsigned long long)seed);
    for (int i = 0; i < 20000; i++) {
        char name[40], file[ESCAPE_FILE_NAME];
        random_name(&random, name, sizeof name);
        char *text = printable_name(name), *back = printable_undo(text);
        assert_non_null(back);
        assert_string_equal(back, name);
        for (const char *at = text; *at; at++)
            assert_false((unsigned char)*at < 0x20 || *at == 0x7f);
        printable_file_name(file, name);
        assert_true(file[0] == '_' || isalnum((unsigned char)file[0]));
        for (const char *at = file; *at; at++)
            assert_true(isalnum((unsigned char)*at) || *at == '-' || *at == '_');
        free(text);
        free(back);
    }
}

static void test_file_names(void **state) {
    (void)state;
    char file[ESCAPE_FILE_NAME];
    printable_file_name(file, "a"); // FNV-1a of "a", 64 bits, from its authors' test vectors
    assert_string_equal(file, "a-af63dc4c8601ec8c");
    printable_file_name(file, "foobar");
    assert_string_equal(file, "foobar-85944171f73967e8");
    printable_file_name(file, "../..");
    assert_int_equal(file[0], '_');
    assert_null(strchr(file, '/'));
}

// Columns as terminals have them: letters of East Asia take two, a mark none.
static void test_columns(void **state) {
    (void)state;
    assert_int_equal(printable_columns(""), 0);
    assert_int_equal(printable_columns("\u00c5ngstr\u00f6m"), 8);
    assert_int_equal(printable_columns("\u738b a"), 4);
    assert_int_equal(printable_columns("e\u0301"), 1);
    assert_int_equal(printable_columns("\xff!"), 2);
    assert_int_equal(printable_clip("\u738b\u738b", 3), 3); // half a letter is none
    assert_int_equal(printable_clip("e\u0301x", 1), 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_known), cmocka_unit_test(test_malformed),
                                       cmocka_unit_test(test_random), cmocka_unit_test(test_file_names),
                                       cmocka_unit_test(test_columns)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
