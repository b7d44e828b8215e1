// The colours of curves as seen by who lacks the red or the green cones, and how they stand out on white.
#include "pages/curve_colors.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

enum { KINDS = 3 };
static const double LEAST_DISTANCE = 20; // in CIELAB; 2 is just seen side by side
static const double LEAST_CONTRAST = 3;  // WCAG 2.2, 1.4.11: parts of pictures

// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes: A Physiologically-based Model for Simulation of Color
// Vision Deficiency, 2009, severity 1: all cones; no L cones; no M cones. Of linear RGB.
static const double seen[KINDS][3][3] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}},
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

static void to_linear(const char *color, double rgb[3]) {
    unsigned bytes[3];
    assert_int_equal(sscanf(color, "#%2x%2x%2x", &bytes[0], &bytes[1], &bytes[2]), 3);
    for (int c = 0; c < 3; c++) {
        double v = bytes[c] / 255.0;
        rgb[c] = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
    }
}

static double luminance(const double rgb[3]) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

static double curve(double t) {
    return t > 216.0 / 24389 ? cbrt(t) : (24389.0 / 27 * t + 16) / 116;
}

// CIELAB under D65 of a colour as this kind of eyes sees it.
static void to_lab(const char *color, int kind, double lab[3]) {
    double rgb[3], as_seen[3];
    to_linear(color, rgb);
    for (int i = 0; i < 3; i++)
        as_seen[i] = fmin(
            fmax(seen[kind][i][0] * rgb[0] + seen[kind][i][1] * rgb[1] + seen[kind][i][2] * rgb[2], 0), 1);
    double x = curve((0.4124 * as_seen[0] + 0.3576 * as_seen[1] + 0.1805 * as_seen[2]) / 0.95047),
           y = curve(luminance(as_seen)),
           z = curve((0.0193 * as_seen[0] + 0.1192 * as_seen[1] + 0.9505 * as_seen[2]) / 1.08883);
    lab[0] = 116 * y - 16, lab[1] = 500 * (x - y), lab[2] = 200 * (y - z);
}

// For the eyes that see the least of it.
static double distance(const char *a, const char *b) {
    double least = INFINITY;
    for (int kind = 0; kind < KINDS; kind++) {
        double p[3], q[3];
        to_lab(a, kind, p);
        to_lab(b, kind, q);
        least = fmin(least, sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                                 (p[2] - q[2]) * (p[2] - q[2])));
    }
    return least;
}

static const char *color(int i) {
    return i < CURVE_COLORS ? curve_colors[i] : curve_color_of_submission;
}

static void test_apart(void **unused) {
    (void)unused;
    double least = INFINITY;
    for (int i = 0; i <= CURVE_COLORS; i++)
        for (int j = 0; j < i; j++) {
            least = fmin(least, distance(color(i), color(j)));
            if (distance(color(i), color(j)) < LEAST_DISTANCE)
                fail_msg("%s and %s are %.1f apart", color(i), color(j), distance(color(i), color(j)));
        }
    print_message("the two nearest are %.1f apart\n", least);
}

static void test_dark_enough(void **unused) {
    (void)unused;
    for (int i = 0; i <= CURVE_COLORS; i++) {
        double rgb[3];
        to_linear(color(i), rgb);
        assert_true(1.05 / (luminance(rgb) + 0.05) >= LEAST_CONTRAST);
    }
}

// White is 100 from black for all eyes. An orange and a brown that who lacks the M cones takes for one; a red
// and a green of one brightness, which all others tell apart.
static void test_refused(void **unused) {
    (void)unused;
    assert_true(fabs(distance("#ffffff", "#000000") - 100) < 0.5);
    assert_true(distance("#d55e00", "#b87d00") < 5 && distance("#0072b2", "#0072b4") < 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_apart), cmocka_unit_test(test_dark_enough),
                                       cmocka_unit_test(test_refused)};
    return cmocka_run_group_tests_name("curve colours", tests, NULL, NULL);
}
