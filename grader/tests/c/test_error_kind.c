// Kinds of error, on pictures made by hand: a dark square on a light ground, changed in one way.
#include "score/error_kind.h"

#include "score/score.h"

#include <math.h>
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
    error_kind(text, sizeof text, &yours, &reference, ERROR_VIEW_SHADED);
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
    error_kind(text, sizeof text, &yours, &reference, ERROR_VIEW_SHADED);
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
    expect(yours, "the same picture, but brighter by the same amount everywhere", "");
    yours = picture();
    for (size_t at = 0; at < image_bytes(&yours); at += 4)
        for (size_t c = 0; c < 3; c++)
            yours.rgba[at + c] = yours.rgba[at + c] == DARK ? 110 : LIGHT - 12;
    expect(yours, "ambient term: the shadows are too bright", "");
}

// Changes of the whole picture, each of which has words of its own.
static void test_whole_kinds(void **unused) {
    (void)unused;
    Image yours = picture();
    square(&yours, 20, 20, 24, LIGHT);
    square(&yours, SIZE - 44, 20, 24, DARK);
    expect(yours, "mirrored", "left and right");
    yours = picture();
    for (size_t at = 0; at < image_bytes(&yours); at += 4)
        for (size_t c = 0; c < 3; c++)
            yours.rgba[at + c] = (uint8_t)(255 - yours.rgba[at + c]);
    expect(yours, "inverted", "");
    yours = picture();
    for (size_t at = 0; at < image_bytes(&yours); at += 4)
        for (size_t c = 0; c < 3; c++)
            yours.rgba[at + c] /= 4;
    expect(yours, "a factor", "too small");
    yours = picture();
    for (size_t at = 0; at < image_bytes(&yours); at += 4)
        yours.rgba[at + 1] /= 2;
    expect(yours, "one channel only: green", "");
}

// A fourth of each block of 4 x 4 pixels is dark, at places that `key` shuffles.
static void sprinkle(Image *image, unsigned key) {
    for (unsigned block = 0; block < SIZE / 4 * SIZE / 4; block++) {
        const int left = (int)(block % (SIZE / 4)) * 4, top = (int)(block / (SIZE / 4)) * 4;
        const unsigned first = (block * 2654435761u + key * 40503u) >> 20;
        square(image, left, top, 4, LIGHT);
        for (unsigned i = 0; i < 4; i++)
            square(image, left + (int)((first + 5 * i) % 4), top + (int)((first / 4 + i) % 4), 1, DARK);
    }
}

static void test_random_numbers(void **unused) {
    (void)unused;
    Image yours = picture(), reference = picture();
    char text[300];
    sprinkle(&reference, 1);
    sprinkle(&yours, 2);
    error_kind(text, sizeof text, &yours, &reference, ERROR_VIEW_SHADED);
    if (!strstr(text, "random numbers"))
        fail_msg("got \"%s\"", text);
    image_destroy(&yours);
    image_destroy(&reference);
}

// A round dark spot with an edge that is `soft` pixels wide, in steps of `step` pixels.
static void spot(Image *image, double soft, int step) {
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const double u = x / step * step + step / 2.0 - SIZE / 2,
                         v = y / step * step + step / 2.0 - SIZE / 2;
            const double lit = fmin(fmax((sqrt(u * u + v * v) - 26) / soft + 0.5, 0), 1);
            memset(image->rgba + 4 * (y * SIZE + x), (int)(DARK + lit * (LIGHT - DARK) + 0.5), 3);
        }
}

static void expect_edge(double soft, int step, double right_soft, ErrorView view, const char *kind) {
    Image yours = picture(), reference = picture();
    char text[300];
    spot(&yours, soft, step);
    spot(&reference, right_soft, 1);
    error_kind(text, sizeof text, &yours, &reference, view);
    if (strncmp(text, kind, strlen(kind)) != 0)
        fail_msg("expected \"%s\", got \"%s\"", kind, text);
    image_destroy(&yours);
    image_destroy(&reference);
}

static void test_edges_of_other_softness(void **unused) {
    (void)unused;
    expect_edge(8, 1, 0.5, ERROR_VIEW_VISIBILITY, "blurred");
    expect_edge(16, 1, 6, ERROR_VIEW_VISIBILITY, "wider penumbra");
    expect_edge(6, 1, 16, ERROR_VIEW_VISIBILITY, "narrower penumbra");
    expect_edge(0.5, 1, 10, ERROR_VIEW_SHADED, "narrower penumbra");
    expect_edge(0.5, 6, 0.5, ERROR_VIEW_VISIBILITY, "too coarse or too fine");
    expect_edge(16, 1, 6, ERROR_VIEW_VALUES, "blurred");
    expect_edge(6, 1, 16, ERROR_VIEW_VALUES, "too sharp, or in blocks");
}

// A spot that grows, and one that moves, are no matter of softness.
static void test_other_edges(void **unused) {
    (void)unused;
    Image yours = picture(), reference = picture();
    char text[300];
    spot(&reference, 6, 1);
    square(&yours, 0, 0, SIZE, LIGHT);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const double lit = fmin(fmax((hypot(x - SIZE / 2, y - SIZE / 2) - 32) / 6 + 0.5, 0), 1);
            memset(yours.rgba + 4 * (y * SIZE + x), (int)(DARK + lit * (LIGHT - DARK) + 0.5), 3);
        }
    error_kind(text, sizeof text, &yours, &reference, ERROR_VIEW_VISIBILITY);
    assert_memory_equal(text, "false shadow", strlen("false shadow"));
    image_destroy(&yours);
    image_destroy(&reference);
}

// Lit everywhere or dark everywhere, of many causes; a shadow that lies elsewhere is something else.
static void test_lost_edges(void **unused) {
    (void)unused;
    Image yours = picture(), reference = picture(), without = picture();
    square(&without, 0, 0, SIZE, LIGHT);
    square(&yours, 0, 0, SIZE, LIGHT);
    assert_true(error_kind_lost_edges(&yours, &reference, &without));
    square(&yours, 0, 0, SIZE, DARK);
    assert_true(error_kind_lost_edges(&yours, &reference, &without));
    square(&yours, 0, 0, SIZE, LIGHT);
    square(&yours, 20, 20, 16, DARK);
    assert_false(error_kind_lost_edges(&yours, &reference, &without));
    assert_false(error_kind_lost_edges(&yours, &without, &without)); // no shadow is wanted
    image_destroy(&yours);
    image_destroy(&reference);
    image_destroy(&without);
}

// A part that is brighter by little is not noise.
static void test_little_is_no_noise(void **unused) {
    (void)unused;
    Image yours = picture(), reference = picture();
    char text[300];
    square(&yours, 50, 50, 40, LIGHT + 5);
    error_kind(text, sizeof text, &yours, &reference, ERROR_VIEW_VALUES);
    assert_null(strstr(text, "random numbers"));
    image_destroy(&yours);
    image_destroy(&reference);
}

// No word of shadows or ambient light where the view has none.
static void test_words_fit_the_view(void **unused) {
    (void)unused;
    Image yours = picture(), reference = picture();
    char text[300];
    square(&yours, 70, 70, 20, DARK);
    error_kind(text, sizeof text, &yours, &reference, ERROR_VIEW_VALUES);
    assert_null(strstr(text, "shadow"));
    assert_null(strstr(text, "0 % too bright"));
    assert_non_null(strstr(text, "too dark"));
    image_destroy(&yours);
    image_destroy(&reference);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_whole_picture),
                                       cmocka_unit_test(test_shadow_and_light),
                                       cmocka_unit_test(test_size),
                                       cmocka_unit_test(test_offset),
                                       cmocka_unit_test(test_edges),
                                       cmocka_unit_test(test_ambient),
                                       cmocka_unit_test(test_whole_kinds),
                                       cmocka_unit_test(test_random_numbers),
                                       cmocka_unit_test(test_little_is_no_noise),
                                       cmocka_unit_test(test_edges_of_other_softness),
                                       cmocka_unit_test(test_other_edges),
                                       cmocka_unit_test(test_lost_edges),
                                       cmocka_unit_test(test_words_fit_the_view)};
    return cmocka_run_group_tests_name("error kind", tests, NULL, NULL);
}
