// The truth's metrics on pictures made by hand.
#include "truth/metrics.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/random.h"
#include "scene/count.h"

enum { SIDE = 8, PIXELS = SIDE * SIDE };

static const MetricsSize size = {SIDE, SIDE};

static void near(double value, double expected) {
    assert_true(fabs(value - expected) < 1e-6); // floats of order 1
}

static void test_primitives(void **unused) {
    (void)unused;
    const uint8_t background[4] = {0, 0, 0, 255}, drawn[4] = {3, 255, 2, 255};
    assert_int_equal(metrics_decode_primitive(background), METRICS_NO_PRIMITIVE);
    assert_int_equal(metrics_decode_primitive(drawn), metrics_primitive(2, 767));
    assert_int_equal(metrics_object(metrics_primitive(2, 767)), 2);
    assert_int_equal(metrics_object(METRICS_NO_PRIMITIVE), -1);
}

// Object 0 on the left half, object 1 on the right: columns 3 and 4 touch the silhouette. One pixel of
// another triangle, one turned away, one just turned far enough, one that is not a number.
static void test_mask(void **unused) {
    (void)unused;
    int32_t drawn[PIXELS], traced[PIXELS];
    float facing[PIXELS], measured[PIXELS];
    uint8_t mask[PIXELS];
    for (int i = 0; i < PIXELS; i++) {
        drawn[i] = traced[i] = metrics_primitive(i % SIDE / 4, 7);
        facing[i] = 1;
        measured[i] = 0;
    }
    drawn[0] = metrics_primitive(0, 8);
    facing[1] = METRICS_LEAST_FACING;
    facing[2] = METRICS_LEAST_FACING + 0.001F;
    measured[8] = NAN;
    measured[9] = INFINITY;
    const MetricsPixels pixels = {drawn, traced, facing, measured};
    assert_int_equal(metrics_mask(size, &pixels, mask), PIXELS - 2 * SIDE - 4);
    const int out[] = {0, 1, 8, 9, 3, 4, 59, 60};
    for (size_t i = 0; i < COUNT(out); i++)
        assert_int_equal(mask[out[i]], 0);
    assert_int_equal(mask[2], 1);
    assert_int_equal(mask[5], 1);
    traced[63] = drawn[63] = METRICS_NO_PRIMITIVE; // a corner of background takes its three neighbours along
    assert_int_equal(metrics_mask(size, &pixels, mask), PIXELS - 2 * SIDE - 4 - 4);
}

// Dark on the left of column 3: the boundary lies between columns 2 and 3, so column x is |x - 2.5| away.
static void test_straight_boundary(void **unused) {
    (void)unused;
    int32_t traced[PIXELS] = {0};
    float truth[PIXELS], distance[PIXELS];
    for (int i = 0; i < PIXELS; i++)
        truth[i] = i % SIDE < 3 ? 0 : 1;
    assert_true(metrics_boundary(size, traced, truth, distance));
    for (int i = 0; i < PIXELS; i++)
        near(distance[i], fabs(i % SIDE - 2.5));
}

// Where the object ends no boundary of the shadow is seen; and without a boundary all is infinitely far.
static void test_no_boundary(void **unused) {
    (void)unused;
    int32_t traced[PIXELS];
    float truth[PIXELS], distance[PIXELS];
    for (int i = 0; i < PIXELS; i++) {
        truth[i] = i % SIDE < 3 ? 0 : 1;
        traced[i] = metrics_primitive(i % SIDE < 3, 0);
    }
    assert_true(metrics_boundary(size, traced, truth, distance));
    for (int i = 0; i < PIXELS; i++)
        assert_true(isinf(distance[i]));
}

// Any picture: the distance is that to the nearest pixel that has a neighbour on the other side, plus half a
// pixel.
static void test_any_boundary(void **unused) {
    (void)unused;
    const uint64_t seed = 11;
    print_message("seed %llu\n", (unsigned long long)seed);
    Random random = {seed};
    int32_t traced[PIXELS] = {0};
    float truth[PIXELS], distance[PIXELS];
    for (int i = 0; i < PIXELS; i++)
        truth[i] = (float)(random_int(&random, 0, 19) == 0);
    truth[PIXELS / 2] = 1;
    assert_true(metrics_boundary(size, traced, truth, distance));
    for (int i = 0; i < PIXELS; i++) {
        double nearest = INFINITY;
        for (int j = 0; j < PIXELS; j++) {
            const int step[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
            for (int k = 0; k < 4; k++) {
                int x = j % SIDE + step[k][0], y = j / SIDE + step[k][1];
                if (x >= 0 && y >= 0 && x < SIDE && y < SIDE && truth[y * SIDE + x] != truth[j])
                    nearest = fmin(nearest, hypot(i % SIDE - j % SIDE, i / SIDE - j / SIDE) + 0.5);
            }
        }
        near(distance[i], nearest);
    }
}

// Of 64 pixels 60 count. Edge (0.5 and 1.5 away, columns 1 to 4): one false shadow of 0.75. Interior: false
// light of 0.5 and of 0.25. An error outside the mask does not count.
static void test_compare(void **unused) {
    (void)unused;
    int32_t traced[PIXELS] = {0};
    float truth[PIXELS], measured[PIXELS], distance[PIXELS];
    uint8_t mask[PIXELS];
    for (int i = 0; i < PIXELS; i++) {
        measured[i] = truth[i] = i % SIDE < 3 ? 0 : 1;
        mask[i] = i >= 4;
    }
    measured[SIDE + 3] -= 0.75f;
    measured[2 * SIDE] += 0.5f;
    measured[3 * SIDE] += 0.25f;
    measured[0] = 1;
    assert_true(metrics_boundary(size, traced, truth, distance));
    Metrics metrics = metrics_compare(size, mask, measured, truth, distance, metrics_edge_width(0.5f, 0.5f));
    assert_int_equal(metrics.all.pixels, 60);
    assert_int_equal(metrics.edge.pixels, 4 * SIDE - 3);
    assert_int_equal(metrics.interior.pixels, 4 * SIDE - 1);
    near(metrics.edge.false_shadow, 0.75 / 60);
    near(metrics.edge.false_light, 0);
    near(metrics.interior.false_shadow, 0);
    near(metrics.interior.false_light, 0.75 / 60);
    near(metrics.all.mae, 1.5 / 60);
    near(metrics.all.bias, 0);
    near(metrics.interior.bias, 0.75 / 60);
    near(metrics.all.rmse, sqrt((0.5625 + 0.25 + 0.0625) / 60));
    near(metrics.edge.rmse * metrics.edge.rmse + metrics.interior.rmse * metrics.interior.rmse,
         metrics.all.rmse * metrics.all.rmse);
}

static void test_edge_width(void **unused) {
    (void)unused;
    near(metrics_edge_width(0, 1), 2);
    near(metrics_edge_width(5, 1.5f), 6.5);
    Metrics nothing = metrics_compare((MetricsSize){0, 0}, NULL, NULL, NULL, NULL, 2);
    near(nothing.all.rmse, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_primitives),        cmocka_unit_test(test_mask),
        cmocka_unit_test(test_straight_boundary), cmocka_unit_test(test_no_boundary),
        cmocka_unit_test(test_any_boundary),      cmocka_unit_test(test_compare),
        cmocka_unit_test(test_edge_width)};
    return cmocka_run_group_tests_name("metrics", tests, NULL, NULL);
}
