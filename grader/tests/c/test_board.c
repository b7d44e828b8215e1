// The contest's page and lines: places that are shared, names of all kinds, and nobody who is ranked.
#include "compete/board.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static Arena arena = {.lab = "14", .most_error = 0.002, .scene = "cubes"};

static Standing standing(const char *name, double taps, const char *reason) {
    Standing it = {.ranked = !reason, .taps = taps, .fragments = 1, .setting = "512 x 512"};
    snprintf(it.name, sizeof it.name, "%s", name);
    snprintf(it.reason, sizeof it.reason, "%s", reason ? reason : "");
    standing_cost(&it);
    return it;
}

static void assert_page(const Standing *standings, int count, const char *const *has,
                        const char *const *has_not) {
    char *page = board_page(standings, count, &arena);
    assert_non_null(page);
    for (; *has; has++)
        if (!strstr(page, *has))
            fail_msg("\"%s\" is not on the page", *has);
    for (; *has_not; has_not++)
        if (strstr(page, *has_not))
            fail_msg("\"%s\" is on the page", *has_not);
    free(page);
}

static void test_ranked(void **unused) {
    (void)unused;
    Standing all[] = {standing("zoe", 3, NULL), standing("<b>bob</b>", 2, NULL), standing("ann", 2.04, NULL),
                      standing("gus", 1, "it does not pass")};
    standing_sort(all, 4);
    assert_string_equal(all[0].name, "<b>bob</b>");
    assert_int_equal(all[1].place, 1); // 2.04 and 2 are the same tenth
    assert_int_equal(all[2].place, 3);
    assert_page(all, 4, (const char *[]){"&lt;b&gt;bob", "ann", "zoe", "Not ranked", "gus", NULL},
                (const char *[]){"<b>bob", "Nobody is ranked", "look at", NULL});
    snprintf(all[1].note, sizeof all[1].note, "read its own lab.c");
    assert_page(all, 4, (const char *[]){"look at", "read its own", NULL}, (const char *[]){NULL});
}

static void test_nobody(void **unused) {
    (void)unused;
    Standing one = standing("gus", 1, "it does not pass: 12 of 100 points");
    assert_page(&one, 1, (const char *[]){"Nobody is ranked yet", "12 of 100 points", NULL},
                (const char *[]){"aria-label=\"Who is ranked\"", NULL});
    assert_page(&one, 0, (const char *[]){"Nobody has handed in", NULL}, (const char *[]){"<table", NULL});
}

// What follows a name stands below what follows the others, whatever letters it has.
static void test_columns(void **unused) {
    (void)unused;
    const Standing all[] = {standing("ann", 2, NULL), standing("\u738b\u5c0f\u660e", 2, NULL),
                            standing("Zoe\u0308 \u00c5", 2, NULL)};
    const size_t bytes_more[] = {
        0, 3, 3}; // than columns: three wide letters of three bytes; a mark of two, a letter of two
    char text[4000] = "";
    FILE *out = fmemopen(text, sizeof text, "w");
    board_print(all, 3, &arena, out);
    assert_int_equal(fclose(out), 0);
    const char *line = text;
    ptrdiff_t first = 0;
    for (int i = 0; i < 3; i++) {
        line = strchr(line, '\n') + 1;
        const ptrdiff_t at = strstr(line, " a pixel") - line;
        first = i ? first : at;
        assert_int_equal(at, first + (ptrdiff_t)bytes_more[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_ranked), cmocka_unit_test(test_nobody),
                                       cmocka_unit_test(test_columns)};
    return cmocka_run_group_tests_name("board", tests, NULL, NULL);
}
