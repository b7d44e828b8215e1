// FLIP against what its authors' program (version 1, 8-bit sRGB pictures of 64 x 64 pixels) says of the same
// pairs.
#include "truth/flip.h"

#include "scene/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

enum { SIDE = 64 };
static const MetricsSize size = {SIDE, SIDE};

static float linear(int srgb) {
    float c = (float)srgb / 255;
    return c <= 0.04045f ? c / 12.92f : powf((c + 0.055f) / 1.055f, 2.4f);
}

typedef struct Pair {
    const char *name;
    int (*reference)(int x, int channel), (*test)(int x, int channel); // sRGB, 0..255
    double mean, most;
} Pair;

// Pictures whose columns are even.
static int black(int x, int c) {
    (void)x, (void)c;
    return 0;
}
static int white(int x, int c) {
    (void)x, (void)c;
    return 255;
}
static int green(int x, int c) {
    (void)x;
    return c == 1 ? 255 : 0;
}
static int blue(int x, int c) {
    (void)x;
    return c == 2 ? 255 : 0;
}
static int grey_100(int x, int c) {
    (void)x, (void)c;
    return 100;
}
static int grey_150(int x, int c) {
    (void)x, (void)c;
    return 150;
}
static int grey_128(int x, int c) {
    (void)x, (void)c;
    return 128;
}
static int grey_129(int x, int c) {
    (void)x, (void)c;
    return 129;
}
static int grey_204(int x, int c) {
    (void)x, (void)c;
    return 204;
}
static int step(int x, int c) {
    (void)c;
    return x < 32 ? 51 : 204;
}
static int step_1(int x, int c) {
    (void)c;
    return x < 33 ? 51 : 204;
}
static int step_4(int x, int c) {
    (void)c;
    return x < 36 ? 51 : 204;
}
static int stripes(int x, int c) {
    (void)c;
    return x % 2 ? 51 : 204;
}

static const Pair pairs[] = {
    {"black and white", black, white, 0.967388, 0.967388},
    {"green and blue", green, blue, 1, 1},
    {"grey 100 and 150", grey_100, grey_150, 0.463707, 0.463707},
    {"grey 128 and 129", grey_128, grey_129, 0.029863, 0.029863},
    {"a step, moved by 1 pixel", step, step_1, 0.035498, 0.606175},
    {"a step, moved by 4 pixels", step, step_4, 0.099954, 0.964944},
    {"grey and stripes", grey_204, stripes, 0.491385, 0.803733},
};

static FlipPicture make(int (*of)(int x, int channel)) {
    static float rgb[SIDE * SIDE * 3];
    FlipPicture picture;
    for (int i = 0; i < SIDE * SIDE * 3; i++)
        rgb[i] = linear(of(i / 3 % SIDE, i % 3));
    assert_true(flip_create(&picture, size, rgb));
    return picture;
}

static void test_reference_values(void **unused) {
    (void)unused;
    for (size_t p = 0; p < sizeof pairs / sizeof *pairs; p++) {
        FlipPicture a = make(pairs[p].reference), b = make(pairs[p].test);
        double most = 0, mean = flip_mean(&a, &b, NULL);
        for (size_t i = 0; i < SIDE * SIDE; i++)
            most = fmax(most, (double)flip_at(&a, &b, i));
        print_message("%s: %.6f (%.6f), most %.6f (%.6f)\n", pairs[p].name, mean, pairs[p].mean, most,
                      pairs[p].most);
        assert_true(fabs(mean - pairs[p].mean) < 5e-5 && fabs(most - pairs[p].most) < 5e-5);
        assert_true(flip_mean(&a, &a, NULL) == 0 && fabs(flip_mean(&b, &a, NULL) - mean) < 1e-12);
        flip_destroy(&a);
        flip_destroy(&b);
    }
}

// A grey picture by one number a pixel is the same as by three; numbers out of range are clamped; sizes that
// are smaller than the filters work.
static void test_grey(void **unused) {
    (void)unused;
    const float grey[] = {-1, 0.25f, 2}, rgb[] = {0, 0, 0, 0.25f, 0.25f, 0.25f, 1, 1, 1},
                other[] = {1, 0, 0.5f};
    FlipPicture a, b, c;
    assert_true(flip_create_grey(&a, (MetricsSize){3, 1}, grey) &&
                flip_create(&b, (MetricsSize){3, 1}, rgb) &&
                flip_create_grey(&c, (MetricsSize){3, 1}, other));
    assert_true(flip_mean(&a, &b, NULL) == 0 && flip_mean(&a, &c, NULL) > 0.1);
    const uint8_t mask[] = {0, 1, 0};
    assert_true(flip_mean(&a, &c, mask) == (double)flip_at(&a, &c, 1));
    flip_destroy(&a);
    flip_destroy(&b);
    flip_destroy(&c);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_reference_values), cmocka_unit_test(test_grey)};
    return cmocka_run_group_tests_name("FLIP", tests, NULL, NULL);
}
