// What may stand in predictions.txt: any text ends in numbers and words about it, and a fault in one line
// costs no other number.
#include "predict/prediction_file.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ENTRIES = 3 };

static PredictionFile file;

static const PredictionFile *read(const char *text) {
    prediction_file_read(&file, text, ENTRIES);
    return &file;
}

static bool is_number(int n, double value) {
    return !file.entry[n].why[0] && file.entry[n].value == value;
}

static void test_good(void **unused) {
    (void)unused;
    static const char *const same[] = {
        "sheet 1234\na 0.5\nb 2e-3\nc -4\n",
        "# a 9\r\nsheet\t1234 # drawn\r\n\r\na 0.5 # half\r\nb .002\r\nc -4.0",
        "c = -4\nB: 2.0e-3\nA) +0.50\nsheet = 1234\n", // another order
        "03.a 0.5\n3.b 0.002\n03.c: -4\nsheet: 1234",
        "sheet\u00a01234\u00a0\n\u202fa\u00a00.5 \u00a0# \u00a0\nb 2e\u22123\nc\u2009\u20134", // an office
                                                                                               // program's
    };
    for (size_t i = 0; i < COUNT(same); i++) {
        read(same[i]);
        if (file.sheet != 1234 || file.message[0] || !is_number(0, 0.5) || !is_number(1, 0.002) ||
            !is_number(2, -4))
            fail_msg("text %zu: sheet %ld, %s, a %s, b %s, c %s", i, file.sheet, file.message,
                     file.entry[0].why, file.entry[1].why, file.entry[2].why);
    }
}

// Each is wrong in b only: a stands.
static void test_bad_numbers(void **unused) {
    (void)unused;
    static const char *const bad[][2] = {
        {"0,25", "with a point and without a comma"},
        {"1,250.5", "without a comma"},
        {"0.25 units", "no unit"},
        {"12texels", "no unit"},
        {"30\xc2\xb0", "no unit"},
        {"50 %", "no unit"},
        {"nan", "is no number"},
        {"inf", "is no number"},
        {"-Infinity", "is no number"},
        {"1e999", "beyond all numbers"},
        {"-1e999", "beyond all numbers"},
        {"0x10", "no unit"},
        {"1\u20132", "is no number"}, // from 1 to 2
        {"1/3", "worked out"},
        {"2*0.5", "worked out"},
        {"about", "is no number"},
        {"e", "is no number"},
        {"1e", "is no number"},
        {"1.2.3", "is no number"},
        {"\x1b[31m1", "is no number"},
        {"0.0000000000000000000000000000000000000000000000000000001", "too long"},
        {"0.5\nb 0.5", "twice"},
        {"?\nb 0.5", "twice"},
        {"?", "nothing is typed"},
        {"???", "nothing is typed"},
        {"", "nothing is typed"},
    };
    for (size_t i = 0; i < COUNT(bad); i++) {
        char text[200];
        snprintf(text, sizeof text, "sheet 7\na 1\nb %s\nc 3\n", bad[i][0]);
        read(text);
        if (!strstr(file.entry[1].why, bad[i][1]) || !is_number(0, 1) || !is_number(2, 3) || file.sheet != 7)
            fail_msg("\"%s\": \"%s\" does not say \"%s\"", bad[i][0], file.entry[1].why, bad[i][1]);
        for (const char *at = file.entry[1].typed; *at; at++)
            assert_true(*at >= ' ' && *at < 0x7f);
    }
}

static void test_bad_files(void **unused) {
    (void)unused;
    static const char *const bad[][2] = {
        {"sheet 7\nsheet 8\na 1", "`sheet` stands there twice"},
        {"sheet 0\na 1", "no number from 1 to"},
        {"sheet -3\na 1", "no number from 1 to"},
        {"sheet 1000000\na 1", "no number from 1 to"},
        {"sheet 99999999999999999999999\na 1", "no number from 1 to"},
        {"sheet 7x\na 1", "no number from 1 to"},
        {"sheet 7\na 1\nd 2", "\"d\" begins a line"},
        {"sheet 7\na 1\nI think so", "\"I\" begins a line"},
    };
    for (size_t i = 0; i < COUNT(bad); i++) {
        read(bad[i][0]);
        if (!strstr(file.message, bad[i][1]) || !is_number(0, 1))
            fail_msg("\"%s\": \"%s\" does not say \"%s\"", bad[i][0], file.message, bad[i][1]);
    }
    assert_int_equal(read("a 1")->sheet, 0);
    assert_int_equal(read("sheet ?\na 1")->sheet, 0);
    assert_int_equal(read("")->sheet, 0);
}

// Bytes of all kinds, as many as a file may have: it ends, and no word of ours holds what a terminal obeys.
static void test_noise(void **unused) {
    (void)unused;
    enum { SIZE = 1 << 16 };
    static char text[SIZE + 1];
    unsigned seed = 20261127;
    print_message("seed %u\n", seed);
    static const char often[] = "abc ?#.,=:\r\n\nsheet0123456789e+-";
    for (int round = 0; round < 20; round++) {
        for (int i = 0; i < SIZE; i++) {
            const int drawn = rand_r(&seed);
            text[i] = (char)(round % 2 ? often[drawn % (int)(sizeof often - 1)] : 1 + drawn % 255);
        }
        read(text);
        for (int n = 0; n < ENTRIES; n++)
            for (const char *at = file.entry[n].why; *at; at++)
                assert_true(*at >= ' ' && *at < 0x7f);
        for (const char *at = file.message; *at; at++)
            assert_true(*at >= ' ' && *at < 0x7f);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_good), cmocka_unit_test(test_bad_numbers),
                                       cmocka_unit_test(test_bad_files), cmocka_unit_test(test_noise)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
