// Kinds of error, on pictures made by hand: a dark square on a light ground, changed in one way.
#include "score/error_kind.h"

#include "score/score.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { SIZE = 96, LIGHT = 200, DARK = 40 };

// A square of side `side` whose upper left corner is (x, y).
static void square(Image *image, int x, int y, int side, uint8_t grey) {
    for (int v = y; v < y + side; v++)
        for (int u = x; u < x + side; u++)
            memset(image->rgba + 4 * (v * SIZE + u), grey, 3);
}

static Image picture(void) {
    Image image;
    assert_true(image_create(&image, SIZE, SIZE));
    score_fill(&image, (const uint8_t[3]){LIGHT, LIGHT, LIGHT});
    square(&image, 20, 20, 24, DARK);
    return image;
}

// Destroys both pictures.
static void expect(Image yours, const char *kind, const char *more) {
    Image reference = picture();
    char text[300];
    error_kind(text, sizeof text, &yours, &reference);
    if (strncmp(text, kind, strlen(kind)) != 0 || !strstr(text, more))
        fail_msg("expected \"%s ... %s\", got \"%s\"", kind, more, text);
    image_destroy(&yours);
    image_destroy(&reference);
}

static void test_whole_picture(void **unused) {
    (void)unused;
    Image yours = picture();
    score_fill(&yours, (const uint8_t[3]){0, 0, 0});
    expect(yours, "nothing drawn", "");
    yours = picture();
    square(&yours, 20, 20, 24, LIGHT);
    square(&yours, 20, SIZE - 44, 24, DARK);
    expect(yours, "upside down", "");
    yours = picture();
    square(&yours, 20, 20, 24, LIGHT);
    square(&yours, 25, 13, 24, DARK);
    expect(yours, "shifted: right, but 5 pixels to the right and 7 up", "");
}

static void test_shadow_and_light(void **unused) {
    (void)unused;
    Image yours = picture();
    square(&yours, 70, 70, 20, DARK);
    expect(yours, "false shadow", "mostly at the lower right");
    yours = picture();
    square(&yours, 20, 20, 24, LIGHT);
    square(&yours, 34, 34, 10, DARK);
    expect(yours, "false light", "mostly at the upper left");
}

// Only the shadow lies elsewhere; a second square stays where it was.
static void test_offset(void **unused) {
    (void)unused;
    Image yours = picture(), reference = picture();
    square(&yours, 20, 20, 24, LIGHT);
    square(&yours, 40, 30, 24, DARK);
    square(&yours, 70, 4, 20, DARK);
    square(&reference, 70, 4, 20, DARK);
    char text[300];
    error_kind(text, sizeof text, &yours, &reference);
    assert_memory_equal(text, "offset", 6);
    image_destroy(&yours);
    image_destroy(&reference);
}

static void test_size(void **unused) {
    (void)unused;
    Image yours = picture();
    square(&yours, 14, 14, 36, DARK); // (36 / 24)^2 = 2.25
    expect(yours, "false shadow", "wrong size: the dark part has 2.2 times its area");
}

static void test_edges(void **unused) {
    (void)unused;
    Image yours = picture();
    for (int v = 20; v < 44; v += 2)
        square(&yours, 44, v, 1, DARK);
    for (int v = 21; v < 44; v += 2)
        square(&yours, 20, v, 1, LIGHT);
    expect(yours, "edges only", "");
}

static void test_ambient(void **unused) {
    (void)unused;
    Image yours = picture();
    for (size_t at = 0; at < image_bytes(&yours); at += 4)
        for (size_t c = 0; c < 3; c++)
            yours.rgba[at + c] += 30;
    expect(yours, "ambient term: the shadows are too bright", "");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whole_picture), cmocka_unit_test(test_shadow_and_light),
        cmocka_unit_test(test_size),          cmocka_unit_test(test_offset),
        cmocka_unit_test(test_edges),         cmocka_unit_test(test_ambient)};
    return cmocka_run_group_tests_name("error kind", tests, NULL, NULL);
}
