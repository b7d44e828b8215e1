// When a mistake may be named: made-up pictures of two checks, of which the second passed, and of the
// mistakes. A mistake is a shade of grey that the first check's picture has, and the second one's.
#include "diagnose/catalogue.h"
#include "score/score.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SIZE = 48, MISTAKES = 3, RIGHT = 200, UNDONE = 40 };

static Change mistakes[MISTAKES] = {
    {.name = "a", .task = "3.1"}, {.name = "b", .task = "3.2"}, {.name = "c", .task = "3.3"}};
static Rubric rubric;
static Exam *exam;
static LabResult result;
static bool failed[RUBRIC_MAX_CHECKS];

// A square of this grey in the middle, on black.
static void paint(Image *image, int grey) {
    if (!image->rgba)
        assert_true(image_create(image, SIZE, SIZE));
    score_fill(image, (const uint8_t[3]){0, 0, 0});
    for (int y = 12; y < 36; y++)
        for (int x = 12; x < 36; x++)
            memset(image->rgba + image_at(image, x, y), grey, 3);
}

static void set_mistake(int m, int first, int second) {
    const int greys[2] = {first, second};
    for (int c = 0; c < 2; c++) {
        LatePicture *late = &exam->mistakes[m][c][0];
        late->known = late->drawn = true;
        paint(&late->image, greys[c]);
    }
}

// The first check failed with a picture of this grey, the second passed.
static int set_up(void **unused) {
    (void)unused;
    rubric = (Rubric){.id = "03", .mistakes = mistakes, .mistake_count = MISTAKES, .check_count = 2};
    exam = calloc(1, sizeof *exam);
    exam->rubric = &rubric;
    result = (LabResult){.check_count = 2};
    for (int c = 0; c < 2; c++) {
        rubric.checks[c] = (Check){.name = "", .task = "3.1", .view = "visibility", .variants = 1};
        result.checks[c] = (CheckResult){.check = &rubric.checks[c], .passed = c == 1};
        paint(&exam->variants[c][0].reference, RIGHT);
        paint(&exam->variants[c][0].without, UNDONE);
        paint(&exam->variants[c][0].skeleton, UNDONE);
        paint(&result.checks[c].yours[0], RIGHT);
        failed[c] = c == 0;
    }
    for (int m = 0; m < MISTAKES; m++)
        set_mistake(m, 50 + 30 * m, RIGHT);
    return 0;
}

static int clean_up(void **unused) {
    (void)unused;
    exam_destroy(exam);
    free(exam);
    for (int c = 0; c < 2; c++)
        image_destroy(&result.checks[c].yours[0]);
    return 0;
}

static Named name(int grey, const ResetFound *found) {
    Named named;
    paint(&result.checks[0].yours[0], grey);
    assert_true(catalogue_find(&named, &result, exam, failed, found));
    return named;
}

static void test_the_nearest_is_named(void **unused) {
    (void)unused;
    const Named named = name(82, NULL);
    assert_int_equal(named.first, 1);
    assert_int_equal(named.second, -1);
    assert_int_equal(named.looks, NAMED_SHOWN);
    assert_int_equal(name(150, NULL).first, -1); // far from all
}

static void test_passed_checks_contradict(void **unused) {
    (void)unused;
    set_mistake(1, 80, 120); // fails the second check, too, which passed
    assert_int_equal(name(80, NULL).first, -1);
}

// ... but not where it passed by the pictures of an alternative.
static void test_another_right_way_contradicts_nothing(void **unused) {
    (void)unused;
    set_mistake(1, 80, 120);
    result.checks[1].otherwise = true;
    assert_int_equal(name(80, NULL).first, 1);
}

static void test_two_that_draw_the_same(void **unused) {
    (void)unused;
    set_mistake(2, 80, RIGHT);
    const Named named = name(80, NULL);
    assert_int_equal(named.first, 1);
    assert_int_equal(named.second, 2);
}

// Its task must be done in the part with the fault.
static void test_outside_of_the_part(void **unused) {
    (void)unused;
    result.fault = (Fault){.count = 1, .parts = {{.file = "lab.c", .tasks = {"3.2"}}}};
    assert_int_equal(name(80, NULL).first, 1);
    result.fault.parts[0].tasks[0] = "3.1";
    assert_int_equal(name(80, NULL).first, -1);
}

// The same where no solution is at hand: in one of the parts that can have it.
static void test_outside_of_the_parts_found(void **unused) {
    (void)unused;
    static ResetFound found;
    char *texts[1] = {strdup("int f(void) { // TODO(3.1)\n}\nint g(void) { // TODO(3.2)\n}\n")};
    rubric.file_count = 1;
    rubric.files[0] = "lab.c";
    static Hint hints[2] = {{.task = "3.1"}, {.task = "3.2"}};
    rubric.hints = hints;
    rubric.hint_count = 2;
    exam->parts = calloc(1, sizeof *exam->parts);
    parts_list(exam->parts, &rubric, texts);
    found = (ResetFound){.any = true, .parts = {true}}; // f
    assert_int_equal(name(80, &found).first, -1);
    found = (ResetFound){.any = true, .parts = {false, true}}; // g
    assert_int_equal(name(80, &found).first, 1);
}

// A picture in one colour has many causes: none is named alone, and where the part is not known, none at all.
static void test_one_colour(void **unused) {
    (void)unused;
    set_mistake(1, 0, RIGHT);
    assert_int_equal(name(0, NULL).first, -1);
    result.fault = (Fault){.count = 1, .parts = {{.file = "lab.c", .tasks = {"3.2"}}}};
    assert_int_equal(name(0, NULL).first, 1);
    assert_int_equal(name(0, NULL).looks, NAMED_PLAIN);
}

// The right picture is black in the square, the one without the task is not: no edge is left of the shadow.
static void test_no_edge_left(void **unused) {
    (void)unused;
    Variant *variant = &exam->variants[0][0];
    score_fill(&variant->reference, (const uint8_t[3]){RIGHT, RIGHT, RIGHT});
    for (int y = 12; y < 36; y++)
        memset(variant->reference.rgba + image_at(&variant->reference, 12, y), 0, (size_t)4 * 24);
    score_fill(&variant->without, (const uint8_t[3]){RIGHT, RIGHT, RIGHT});
    LatePicture *late = &exam->mistakes[1][0][0];
    score_fill(&late->image, (const uint8_t[3]){RIGHT, RIGHT, RIGHT});
    memset(late->image.rgba, 0, 3); // one pixel: not in one colour
    Image *yours = &result.checks[0].yours[0];
    memcpy(yours->rgba, late->image.rgba, image_bytes(yours));
    Named named;
    assert_true(catalogue_find(&named, &result, exam, failed, NULL));
    assert_int_equal(named.first, 1);
    assert_int_equal(named.looks, NAMED_NO_EDGES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_the_nearest_is_named, set_up, clean_up),
        cmocka_unit_test_setup_teardown(test_passed_checks_contradict, set_up, clean_up),
        cmocka_unit_test_setup_teardown(test_another_right_way_contradicts_nothing, set_up, clean_up),
        cmocka_unit_test_setup_teardown(test_two_that_draw_the_same, set_up, clean_up),
        cmocka_unit_test_setup_teardown(test_outside_of_the_part, set_up, clean_up),
        cmocka_unit_test_setup_teardown(test_outside_of_the_parts_found, set_up, clean_up),
        cmocka_unit_test_setup_teardown(test_one_colour, set_up, clean_up),
        cmocka_unit_test_setup_teardown(test_no_edge_left, set_up, clean_up)};
    return cmocka_run_group_tests_name("naming", tests, NULL, NULL);
}
