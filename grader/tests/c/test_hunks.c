// What differs between two versions of a function: which words and lines, and whether two versions differ in
// the same place.
#include "compile/hunks.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static Hunks differ(const char *theirs, const char *ours) {
    Hunks hunks;
    hunks_find(&hunks, (TextPart){theirs, 0, strlen(theirs)}, (TextPart){ours, 0, strlen(ours)});
    return hunks;
}

// One hunk: our words from `first` to before `end`, on these lines.
static void expect_one(const char *theirs, const char *ours, Hunk wanted) {
    const Hunks hunks = differ(theirs, ours);
    assert_false(hunks.unknown);
    assert_int_equal(hunks.count, 1);
    assert_memory_equal(&hunks.list[0], &wanted, sizeof wanted);
}

static const char ours[] = "a = 1;\nb = 2;\nc = 3;\n"; // 12 words, 4 a line

static void test_hunks(void **unused) {
    (void)unused;
    expect_one("a = 1;\nb = 7;\nc = 3;\n", ours, (Hunk){6, 7, 2, 2});
    expect_one("a = 1; c = 3;", ours, (Hunk){4, 8, 2, 2});
    expect_one("a = 1; b = 2; f(); c = 3;", ours, (Hunk){8, 8, 2, 3});
    expect_one("f(); a = 1; b = 2; c = 3;", ours, (Hunk){0, 0, 1, 1});
    expect_one("a = 1; b = 2;", ours, (Hunk){8, 12, 3, 3});
    assert_int_equal(differ("a=1; /* b */ b = 2; // d\nc = 3;", ours).count, 0);
    assert_int_equal(differ("a = 0; b = 2; c = 0;", ours).count, 2);
    assert_int_equal(differ("", ours).count, 1);
}

static void test_part_of_a_text(void **unused) {
    (void)unused;
    Hunks hunks;
    hunks_find(&hunks, (TextPart){"x b = 9; y", 2, 8}, (TextPart){ours, 7, 13});
    assert_int_equal(hunks.count, 1);
    assert_int_equal(hunks.list[0].first_line, 2);
}

static void test_meeting(void **unused) {
    (void)unused;
    const Hunks second = differ("a = 1; b = 7; c = 3;", ours), same = differ("a = 1; b = f(8); c = 3;", ours),
                third = differ("a = 1; b = 2; c = 7;", ours), put = differ("a = 1; b = 2; f(); c = 3;", ours),
                gone = differ("a = 1; b = 2;", ours);
    assert_true(hunks_meet(&second, &same));
    assert_false(hunks_meet(&second, &third));
    assert_true(hunks_meet(&gone, &third));
    assert_true(hunks_meet(&put, &put));
    assert_false(hunks_meet(&put, &gone)); // before it
    assert_false(hunks_meet(&put, &second));
}

// What cannot be told meets everything.
static void test_too_much(void **unused) {
    (void)unused;
    char *many = malloc(4 * HUNKS_MOST_WORDS + 1);
    assert_non_null(many);
    for (int i = 0; i < 2 * HUNKS_MOST_WORDS; i++)
        memcpy(many + 2 * i, "x ", 3);
    const Hunks unknown = differ(many, ours), second = differ("a = 1; b = 7; c = 3;", ours);
    assert_true(unknown.unknown);
    assert_true(hunks_meet(&unknown, &second));
    free(many);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_hunks), cmocka_unit_test(test_part_of_a_text),
                                       cmocka_unit_test(test_meeting), cmocka_unit_test(test_too_much)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
