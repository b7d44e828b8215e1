// The verdict on a curve: right ones hold, each kind of wrong one is refused.
#include "stability/curve.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { POINTS = 8 };

// y = 3 x^exponent at x = 1, 2, 4 ..., expected to be just that, with the tolerance 0.1.
static Curve power(CurveRule rule, double exponent) {
    Curve curve = {.rule = rule, .slope = exponent, .tolerance = 0.05};
    for (int i = 0; i < POINTS; i++) {
        double y = 3 * pow(1 << i, exponent);
        curve_add(&curve, 1 << i, y, y, 0.1);
    }
    return curve;
}

static void check(const Curve *curve, bool holds) {
    CurveVerdict verdict = curve_judge(curve);
    assert_int_equal(verdict.holds, holds);
    assert_int_equal(verdict.share <= 1, holds);
    assert_true(isfinite(verdict.share));
}

// Moves one point; the verdict must be the same whichever it is.
static void check_moved(CurveRule rule, double by, bool holds) {
    for (int i = 0; i < POINTS; i++) {
        Curve curve = power(rule, -0.5);
        curve.points[i].measured += by;
        check(&curve, holds);
    }
}

static void test_levels(void **unused) {
    (void)unused;
    const CurveRule rules[] = {CURVE_EQUAL, CURVE_LEAST, CURVE_MOST};
    for (int i = 0; i < 3; i++) {
        check_moved(rules[i], 0.09, true);
        check_moved(rules[i], -0.09, true);
        check_moved(rules[i], 0.11, rules[i] == CURVE_LEAST);
        check_moved(rules[i], -0.11, rules[i] == CURVE_MOST);
        check_moved(rules[i], NAN, false);
        check_moved(rules[i], INFINITY, false);
    }
}

static void test_worst_is_reported(void **unused) {
    (void)unused;
    Curve curve = power(CURVE_EQUAL, 1);
    curve.points[2].measured += 0.2;
    curve.points[5].measured -= 0.3;
    CurveVerdict verdict = curve_judge(&curve);
    assert_true(fabs(verdict.share - 3) < 1e-9 && verdict.expected == 96);
}

static void test_no_tolerance(void **unused) {
    (void)unused;
    Curve curve = {.rule = CURVE_EQUAL};
    curve_add(&curve, 1, 0, 0, 0);
    check(&curve, true);
    curve.points[0].measured = 1e-9;
    check(&curve, false);
}

static void test_empty(void **unused) {
    (void)unused;
    for (int rule = CURVE_EQUAL; rule <= CURVE_FALLING; rule++) {
        Curve curve = {.rule = (CurveRule)rule, .tolerance = 1};
        check(&curve, false);
    }
}

static void test_slope(void **unused) {
    (void)unused;
    Curve curve = power(CURVE_SLOPE, -0.75);
    assert_true(fabs(curve_exponent(&curve) + 0.75) < 1e-9);
    check(&curve, true);
    curve.slope = -0.71;
    check(&curve, true);
    curve.slope = -0.69;
    check(&curve, false);
    curve.points[3].measured = 0; // no logarithm
    check(&curve, false);
    curve.count = 1; // no line
    check(&curve, false);
}

static void test_monotone(void **unused) {
    (void)unused;
    Curve curve = power(CURVE_RISING, 0.5);
    check(&curve, true);
    curve.rule = CURVE_FALLING;
    check(&curve, false);
    curve = power(CURVE_FALLING, -0.5);
    check(&curve, true);
    curve.rule = CURVE_RISING;
    check(&curve, false);
    curve = power(CURVE_RISING, 0); // flat
    check(&curve, false);
    curve = power(CURVE_RISING, 0.5);
    curve.points[4].measured = curve.points[3].measured - 0.2; // a dent
    check(&curve, false);
    curve.points[4].measured = NAN;
    check(&curve, false);
    curve.count = 1;
    check(&curve, false);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_levels),       cmocka_unit_test(test_worst_is_reported),
        cmocka_unit_test(test_no_tolerance), cmocka_unit_test(test_empty),
        cmocka_unit_test(test_slope),        cmocka_unit_test(test_monotone)};
    return cmocka_run_group_tests_name("curves", tests, NULL, NULL);
}
