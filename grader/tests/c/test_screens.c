// What the watch shows of points: nothing looks whole that is not; how far a sheet can be scrolled; colours.
#include "watch/screens.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static LabBoard board;
static Sheet sheet;

// The screen of a lab with one check of `most` points, of which there are `points`.
static void show_in(int columns, double points, int most, bool passed) {
    memset(&board, 0, sizeof board);
    board = (LabBoard){.folder = "labs", .lab_count = 1, .known = true, .score_before = -1};
    board.rubrics[0] = (Rubric){.id = "03", .folder = "solutions/03-test", .title = "t", .check_count = 1};
    board.rubrics[0].checks[0] = (Check){.name = "c", .task = "3.1", .points = most};
    board.verdict = (LabVerdict){.status = LAB_FAILED, .score = points, .max_score = most, .check_count = 1};
    board.verdict.checks[0] = (VerdictCheck){.points = points, .passed = passed};
    board.focus.check = passed ? -1 : 0;
    sheet_begin(&sheet, columns);
    screens_lab(&sheet, &board, false);
}

static void show(double points, int most, bool passed) {
    show_in(100, points, most, passed);
}

static bool shown(const char *text) {
    for (int i = 0; i < sheet.count; i++)
        if (strstr(sheet.lines[i].text, text))
            return true;
    return false;
}

static void test_points(void **unused) {
    (void)unused;
    static const struct {
        double points;
        int most;
        bool passed;
        const char *check, *lab;
    } cases[] = {
        {7.97, 8, false, " 7.9 of 8", " 7 of 8"},
        {11.4, 12, true, "11.4 of 12", " 11 of 12"},
        {8, 8, true, "   8 of 8", " 8 of 8"},
        {0, 15, false, "   0 of 15", " 0 of 15"},
        {0.04, 15, false, "   0 of 15", " 0 of 15"},
        {100, 100, true, " 100 of 100", " 100 of 100"},
        {99.99, 100, true, "99.9 of 100", " 99 of 100"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        show(cases[i].points, cases[i].most, cases[i].passed);
        if (!shown(cases[i].check) || !shown(cases[i].lab))
            fail_msg("%.2f of %d is not shown as \"%s\"", cases[i].points, cases[i].most, cases[i].check);
    }
}

static void test_scrolling(void **unused) {
    (void)unused;
    sheet_begin(&sheet, 80);
    for (int i = 0; i < 20; i++)
        sheet_line(&sheet, STYLE_PLAIN, "%d", i);
    assert_int_equal(sheet_last_top(&sheet, 21), 0); // 20 lines and the keys
    assert_int_equal(sheet_last_top(&sheet, 20), 1);
    assert_int_equal(sheet_last_top(&sheet, 2), 19);
}

// What is marked in a list is seen, from wherever one comes, and lines that are seen do not jump.
static void test_marked(void **unused) {
    (void)unused;
    sheet_begin(&sheet, 80);
    for (int i = 0; i < 18; i++)
        sheet_line(&sheet, STYLE_PLAIN, "%d", i);
    for (int rows = 3; rows < 25; rows++)
        for (int line = 0; line < 18; line++)
            for (int from = 0; from <= sheet_last_top(&sheet, rows); from++) {
                const int top = sheet_top_with(&sheet, line, from, rows), room = rows - 1;
                const int seen = top == sheet_last_top(&sheet, rows) ? room : room - 1;
                assert_true(top >= 0 && top <= line && line < top + seen);
                assert_true(line < from || line >= from + room - 1 || top == from);
            }
    assert_int_equal(sheet_top_with(&sheet, 17, 0, 40), 0);
}

// In a terminal of any width the points are seen, and no line is cut off.
static void test_narrow(void **unused) {
    (void)unused;
    for (int columns = 34; columns < 110; columns++) {
        show_in(columns, 99.99, 100, false);
        assert_true(shown("99.9 of 100"));
        for (int i = 0; i < sheet.count; i++)
            if (strlen(sheet.lines[i].mark) + strlen(sheet.lines[i].text) > (size_t)columns)
                fail_msg("%d columns: %s", columns, sheet.lines[i].text);
        sheet_begin(&sheet, columns);
        const int marked = screens_list(&sheet, &board, 0);
        assert_int_equal(marked, sheet.count - 1);
        assert_true(strlen(sheet.lines[sheet.count - 1].text) <= (size_t)columns - 2);
    }
    sheet_begin(&sheet, 22);
    sheet_text(
        &sheet, STYLE_PLAIN, 0,
        "\u00dc\u00dc\u00dc\u00dc\u00dc\u00dc\u00dc\u00dc\u00dc\u00dc\u00dc\u00dc \u00dc\u00dc\u00dc\u00dc");
    assert_int_equal(sheet.count, 1); // 17 letters of two bytes
}

// What goes on from a line of a list stands below its words; what follows it, below its dash.
static void test_hanging(void **unused) {
    (void)unused;
    static const char *const wanted[] = {"  - one two three four", "    five", "  six seven eight nine",
                                         "  ten"};
    sheet_begin(&sheet, 24);
    sheet_text(&sheet, STYLE_PLAIN, 2, "- one two three four five\nsix seven eight nine ten");
    assert_int_equal(sheet.count, 4);
    for (int i = 0; i < 4; i++)
        assert_string_equal(sheet.lines[i].text, wanted[i]);
}

// The luminance of a colour of the 6 x 6 x 6 cube, by WCAG 2.2.
static double cube_luminance(int number) {
    static const double weights[] = {0.0722, 0.7152, 0.2126}; // blue, green, red: the last digit first
    double sum = 0;
    number -= 16;
    for (int i = 0; i < 3; i++, number /= 6) {
        const double value = number % 6 ? (55 + 40 * (number % 6)) / 255.0 : 0;
        sum += weights[i] * (value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4));
    }
    return sum;
}

// Colours are read on white and on black; a terminal of 16 colours gets none that is pale on either.
static void test_colors(void **unused) {
    (void)unused;
    setenv("TERM", "xterm-256color", 1);
    unsetenv("COLORTERM");
    for (ColorUse use = COLOR_GOOD; use <= COLOR_NOTE; use++) {
        int number = 0;
        assert_int_equal(sscanf(color_begin(use), "\033[38;5;%dm", &number), 1);
        assert_in_range(number, 16, 231);
        assert_true(1.05 / (cube_luminance(number) + 0.05) >= 3.9);
        assert_true((cube_luminance(number) + 0.05) / 0.05 >= 3.9);
    }
    setenv("TERM", "vt220", 1);
    for (ColorUse use = COLOR_PLAIN; use <= COLOR_DIM; use++)
        for (int pale = 3; pale <= 7; pale += 4) { // yellow and white
            const char code[] = {'3', (char)('0' + pale), 'm', '\0'};
            assert_null(strstr(color_begin(use), code));
        }
    assert_string_equal(color_begin(COLOR_PLAIN), "");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_points),  cmocka_unit_test(test_scrolling),
                                       cmocka_unit_test(test_marked),  cmocka_unit_test(test_narrow),
                                       cmocka_unit_test(test_hanging), cmocka_unit_test(test_colors)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
