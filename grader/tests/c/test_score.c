// The metrics against closed forms and, as an independent witness, ImageMagick's compare.
#include "score/score.h"

#include "scene/check.h"
#include "scene/random.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { SIZE = 64 };

static Image make_plain(uint8_t grey) {
    Image image;
    assert_true(image_create(&image, SIZE, SIZE));
    score_fill(&image, (const uint8_t[3]){grey, grey, grey});
    return image;
}

// Paints the columns from..to-1.
static void paint(Image *image, int from, int to, uint8_t grey) {
    for (int y = 0; y < SIZE; y++)
        for (int x = from; x < to; x++)
            memset(image->rgba + 4 * (y * SIZE + x), grey, 3);
}

// Reference: a black bar on white; the skeleton and the solution without the task are white.
static FrameScore score_bar(int from, int to, uint8_t grey) {
    Image reference = make_plain(255), white = make_plain(255), yours = make_plain(255);
    paint(&reference, 16, 32, 0);
    paint(&yours, from, to, grey);
    FrameScore score = score_frame(&yours, &reference, &white, &white);
    image_destroy(&reference);
    image_destroy(&white);
    image_destroy(&yours);
    return score;
}

static void test_extremes(void **unused) {
    (void)unused;
    assert_true(score_bar(16, 32, 0).share == 1);
    FrameScore missing = score_bar(0, 0, 0);
    assert_true(missing.share == 0 && missing.inside == 1 && missing.outside == 0);
    FrameScore black = score_bar(0, SIZE, 0);
    assert_true(black.share == 0 && black.inside == 0 && black.outside == 1);
}

static void test_partial(void **unused) {
    (void)unused;
    // A quarter of the bar missing: inside is 1/4. Bar 4 columns too wide: 4 of 16 columns of a window are
    // wrong.
    assert_true(fabs(score_bar(16, 28, 0).inside - 0.25) < 1e-12);
    assert_true(fabs(score_bar(16, 36, 0).outside - 0.25) < 1e-12);
    // Within the tolerance of 2/255 nothing is wrong; a tenth of the way from 0 to 13/255 in between is
    // linear.
    assert_true(score_bar(16, 32, 2).inside == 0);
    assert_true(fabs(score_bar(16, 32, 6).inside - 6 / (0.05 * 255)) < 1e-9);
    assert_true(score_bar(16, 32, 13).inside == 1);
}

static void test_more_broken_never_more(void **unused) {
    (void)unused;
    double last = 1;
    for (int to = 32; to >= 16; to--) {
        double share = score_bar(16, to, 0).share;
        assert_true(share <= last);
        last = share;
    }
    assert_true(last == 0);
}

// A light's colour typed otherwise dims what is lit by a tenth: most of the points stay.
static void test_other_colour_does_not_outweigh(void **unused) {
    (void)unused;
    Image reference = make_plain(255), white = make_plain(255), yours = make_plain(230);
    paint(&reference, 16, 32, 0);
    paint(&yours, 16, 32, 0);
    double share = score_frame(&yours, &reference, &white, &white).share;
    assert_true(share > 0.5 && share < 1);
    image_destroy(&reference);
    image_destroy(&white);
    image_destroy(&yours);
}

static void test_not_finite(void **unused) {
    (void)unused;
    Image reference = make_plain(0), white = make_plain(255), yours = make_plain(0);
    for (size_t at = 3; at < image_bytes(&yours); at += 4)
        yours.rgba[at] = 0;
    assert_true(score_frame(&yours, &reference, &white, &white).share == 0);
    assert_int_equal(score_count(&yours, &reference), SIZE * SIZE);
    image_destroy(&reference);
    image_destroy(&white);
    image_destroy(&yours);
}

// What `compare -metric METRIC` prints for two pictures.
static double witness(const char *metric, const char *a, const char *b) {
    char command[512], line[256] = "";
    snprintf(command, sizeof command, "compare -metric %s %s %s null: 2>&1", metric, a, b);
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    assert_non_null(fgets(line, sizeof line, pipe));
    pclose(pipe);
    const char *unit = strchr(line, '('); // RMSE prints "1234.5 (0.0188)", AE a plain number
    return atof(unit ? unit + 1 : line);
}

static void test_imagemagick(void **unused) {
    (void)unused;
    Image a = make_plain(0), b = make_plain(0);
    Random random = {2026};
    print_message("seed 2026\n");
    for (size_t at = 0; at < image_bytes(&a); at++)
        if (at % 4 != 3) {
            a.rgba[at] = (uint8_t)random_int(&random, 0, 255);
            b.rgba[at] = random_int(&random, 0, 3) ? a.rgba[at] : (uint8_t)random_int(&random, 0, 255);
        }
    char path_a[64], path_b[64];
    snprintf(path_a, sizeof path_a, "/tmp/shadow-lab-a-%d.png", (int)getpid());
    snprintf(path_b, sizeof path_b, "/tmp/shadow-lab-b-%d.png", (int)getpid());
    assert_true(image_write_png(&a, path_a) && image_write_png(&b, path_b));
    double rmse = witness("RMSE", path_a, path_b);
    assert_true(fabs(rmse - score_rmse(&a, &b) / 255) < 1e-5);
    size_t differing = 0; // AE counts any difference; score_count those above its tolerance
    for (size_t at = 0; at < image_bytes(&a); at += 4)
        differing += memcmp(a.rgba + at, b.rgba + at, 3) != 0;
    assert_true(witness("AE", path_a, path_b) == (double)differing);
    assert_true(score_count(&a, &b) <= differing && score_count(&a, &b) > differing * 9 / 10);
    unlink(path_a);
    unlink(path_b);
    image_destroy(&a);
    image_destroy(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_extremes),    cmocka_unit_test(test_partial),
        cmocka_unit_test(test_not_finite),  cmocka_unit_test(test_more_broken_never_more),
        cmocka_unit_test(test_imagemagick), cmocka_unit_test(test_other_colour_does_not_outweigh),
    };
    return cmocka_run_group_tests_name("score", tests, NULL, NULL);
}
