// What a method changes beyond the truth, from frame to frame, against sums made by hand.
#include "study/motion.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

// A true edge that goes from pixel 10 to 12. A ramp of 6 pixels goes with it and sweeps the same area, 2; a
// pixel that goes out is 1 more; what stands still lacks 2; what does not count is left out.
static void test_motion(void **unused) {
    (void)unused;
    enum { LONG = 24 };
    float truth[2][LONG], shown[2][LONG];
    uint8_t counts[2][LONG];
    double count = 0;
    MotionFrame frames[2];
    for (int f = 0; f < 2; f++) {
        frames[f] = (MotionFrame){.truth = truth[f], .counts = counts[f]};
        for (int x = 0; x < LONG; x++) {
            counts[f][x] = 1;
            truth[f][x] = x >= 10 + 2 * f;
            shown[f][x] = fminf(fmaxf(((float)x - 7 - 2 * (float)f) / 6, 0), 1);
        }
    }
    const float *const moved[2] = {shown[0], shown[1]}, *const still[2] = {shown[0], shown[0]};
    const MetricsSize size = {LONG, 1};
    assert_true(fabs(motion_changes(size, moved, frames, &count)) < 1e-6 && count == LONG);
    assert_true(fabs(motion_changes(size, still, frames, &count) + 2) < 1e-6);
    shown[1][2] = 1; // dark before
    assert_true(fabs(motion_changes(size, moved, frames, &count) - 1) < 1e-6);
    counts[0][2] = 0;
    count = 0;
    assert_true(fabs(motion_changes(size, moved, frames, &count)) < 1e-6 && count == LONG - 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_motion)};
    return cmocka_run_group_tests_name("motion", tests, NULL, NULL);
}
