// The truth of whole pixels against areas worked out by hand: how much of each pixel an edge leaves lit, and
// how much it scatters about that.
#include "truth/pixels.h"

#include "scene/check.h"
#include "truth/closed_scenes.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

enum { SIDE = 32, ACROSS = 8 };
static const uint64_t seeds[] = {1, 77, 123456789};

typedef struct Wall {
    Truth truth;
    TruthPicture centers;
    float visibility[SIDE * SIDE], noise[SIDE * SIDE];
} Wall;

// A wall that fills the picture, one unit a pixel, and a large plate before it, lit from straight ahead: its
// shadow's edge passes `off` pixels right of the picture's middle, turned by `turn` radians against the
// vertical.
static void make_wall(Wall *wall, float off, float turn) {
    Scene scene = closed_wall(100, 16, 2 * atanf(1));
    const float big = 60;
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, 20), vec3_make(0, 0, 0), 0, 50, 1, 30);
    vec3s center = vec3_make(off - big * cosf(turn), -big * sinf(turn), 18); // behind the camera
    closed_add(&scene, SHAPE_BOX, center, vec3_make(1, 1, 1), 0);
    mat4s *placed = &scene.objects[1].world_from_object;
    *placed = glms_scale(glms_rotate(glms_translate_make(center), turn, vec3_make(0, 0, 1)),
                         vec3_make(big, big, 0.001f));
    assert_true(truth_create(&wall->truth, &scene) && truth_picture_create(&wall->centers, SIDE, SIDE));
    truth_look(&wall->truth, &wall->centers);
}

static void drop_wall(Wall *wall) {
    truth_picture_destroy(&wall->centers);
    truth_destroy(&wall->truth);
}

// Share of the unit square around (x, y) on the side u * x + v * y > d of a line, by 400 x 400 points.
static double lit_share(double x, double y, double u, double v, double d) {
    int lit = 0;
    for (int i = 0; i < 160000; i++)
        lit += u * (x + (i % 400 + 0.5) / 400 - 0.5) + v * (y + (i / 400 + 0.5) / 400 - 0.5) > d; // NOLINT
    return lit / 160000.0;
}

// An edge along a column of pixels that leaves `share` of it lit: the columns left of it are dark, those
// right of it lit; 8 strata are cut, each at its own random place.
static void test_column(void **unused) {
    (void)unused;
    static Wall wall;
    for (int tenth = 3; tenth < 10; tenth += 2)
        for (size_t s = 0; s < 3; s++) {
            const TruthQuery query = {.kind = TRUTH_LIGHT, .seed = seeds[s]};
            double share = tenth / 10.0, sum = 0;
            make_wall(&wall, 1 - (float)share, 0);
            assert_true(
                pixels_trace_twice(&wall.truth, &wall.centers, &query, ACROSS, wall.visibility, wall.noise));
            for (int i = 0; i < SIDE * SIDE; i++) {
                int x = i % SIDE;
                assert_true(x == SIDE / 2 || wall.visibility[i] == (x > SIDE / 2));
                sum += x == SIDE / 2 ? (double)wall.visibility[i] : 0;
            }
            print_message("seed %llu: %.4f of the column lit, expected %.4f\n", (unsigned long long)seeds[s],
                          sum / SIDE, share);
            assert_true(fabs(sum / SIDE - share) < 0.01);
            drop_wall(&wall);
        }
}

// Edges in many directions: each pixel's value against its share. A line cuts at most 2 k - 1 of k x k
// strata, each of which scatters by at most 1/2 of its area: the standard deviation is at most sqrt(2 k - 1)
// / (2 k^2), .030 for k = 8, and of the mean of two .021. Without strata it would be up to .0625 and .044.
static void test_noise(void **unused) {
    (void)unused;
    static Wall wall;
    double bound = sqrt(2.0 * ACROSS - 1) / (2.0 * ACROSS * ACROSS) / sqrt(2), squares = 0, noise = 0,
           error = 0;
    int edge = 0;
    for (int degrees = 0; degrees < 90; degrees += 15) {
        const TruthQuery query = {.kind = TRUTH_LIGHT, .seed = seeds[0] + (uint64_t)degrees};
        float turn = glm_rad((float)degrees);
        make_wall(&wall, 0.3f, turn);
        assert_true(
            pixels_trace_twice(&wall.truth, &wall.centers, &query, ACROSS, wall.visibility, wall.noise));
        for (int i = 0; i < SIDE * SIDE; i++) {
            double x = i % SIDE - SIDE / 2 + 0.5, y = SIDE / 2 - 0.5 - i / SIDE; // NOLINT
            double share = lit_share(x, y, cosf(turn), sinf(turn), 0.3 * cosf(turn)),
                   off = (double)wall.visibility[i] - share;
            if (share <= 0 || share >= 1) {
                assert_true(fabs(off) < 1e-6 && fabsf(wall.noise[i]) < 1e-6f);
                continue;
            }
            squares += off * off;
            error += fabs(off);
            noise += fabs((double)wall.noise[i]);
            edge++;
        }
        drop_wall(&wall);
    }
    print_message("%d pixels at edges: off by %.4f (bound %.4f), mean %.4f, by the two traces %.4f\n", edge,
                  sqrt(squares / edge), bound, error / edge, noise / edge);
    assert_true(sqrt(squares / edge) < bound && fabs(noise / error - 1) < 0.2);
}

// Wide light: all shares together are the samples of the whole, so the sum over the shares of a pixel counts
// as many rays, and the disc beside an endless edge is half seen from right below it.
static void test_wide(void **unused) {
    (void)unused;
    static Wall wall;
    make_wall(&wall, 0, 0);
    TruthQuery query = {.kind = TRUTH_DISC,
                        .area = {{{0, 0, 20}}, {{1, 0, 0}}, {{0, 1, 0}}},
                        .samples = 1024,
                        .seed = seeds[1]};
    assert_true(pixels_trace_twice(&wall.truth, &wall.centers, &query, ACROSS, wall.visibility, wall.noise));
    double sum = 0, middle = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE;
        sum += (double)wall.visibility[i];
        middle += x == SIDE / 2 || x == SIDE / 2 - 1 ? (double)wall.visibility[i] : 0;
    }
    // The edge is at x = 0, 2 below a lamp of radius 1 at height 20: half of the lamp is seen at x = 0, and
    // the picture is symmetric about it.
    print_message("seen in the middle %.4f, in all of the picture %.4f\n", middle / (2 * SIDE),
                  sum / (SIDE * SIDE));
    assert_true(fabs(middle / (2 * SIDE) - 0.5) < 0.01 && fabs(sum / (SIDE * SIDE) - 0.5) < 0.002);
    query.samples = 1000;
    assert_false(pixels_trace(&wall.truth, &wall.centers, &query, ACROSS, wall.visibility));
    drop_wall(&wall);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_column), cmocka_unit_test(test_noise),
                                       cmocka_unit_test(test_wide)};
    return cmocka_run_group_tests_name("pixels", tests, NULL, NULL);
}
