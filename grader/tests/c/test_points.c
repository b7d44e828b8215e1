// The error of a student's method beside recorded points, by hand.
#include "points/own_points.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static void test_errors(void **unused) {
    (void)unused;
    Image truth = {0}, frame = {0};
    assert_true(image_create(&truth, 4, 1) && image_create(&frame, 4, 1));
    const uint8_t right[16] = {255, 255, 255, 255, 0, 0, 255, 255, 128, 128, 255, 255, 255, 255, 0, 255},
                  drawn[16] = {255, 255, 255, 255, 51, 51, 51, 255, 0, 0, 0, 0, 0, 0, 0, 255};
    memcpy(truth.rgba, right, sizeof right);
    memcpy(frame.rgba, drawn, sizeof drawn);
    // 0, 51 / 255, wholly wrong for no finite colour, and one that does not count.
    assert_true(fabs(own_points_error(&frame, &truth) - (0 + 0.2 + 1) / 3) < 1e-6);
    memset(truth.rgba, 0, 16);
    assert_true(own_points_error(&frame, &truth) == 0); // nothing counts
    image_destroy(&truth);
    image_destroy(&frame);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_errors)};
    return cmocka_run_group_tests_name("points", tests, NULL, NULL);
}
