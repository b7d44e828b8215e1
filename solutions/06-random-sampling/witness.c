// The penumbrae of lab 06's solution against closed forms (they stand at each test).
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 640, MAP = 1024, PATTERN = 32, COLUMNS = 4, ROWS = 8, SAMPLES = COLUMNS * ROWS };

static const float map_half_size = 4, radius = 0.4f; // of the disc, world units in the light's cross-section

static Image draw(const Scene *scene, bool early_out) {
    const WitnessKnob knobs[] = {{"map size", MAP},         {"radius", radius / (2 * map_half_size) * MAP},
                                 {"columns", COLUMNS},      {"rows", ROWS},
                                 {"pattern size", PATTERN}, {"early-out", early_out}};
    return witness_draw(LAB_ID, scene, "visibility", SIZE, SIZE, knobs, 6);
}

static double lit_at(const Image *image, int x, int y) {
    return image->rgba[4 * (y * SIZE + x)] / 255.0;
}

// A wall with a light from the left, 45 degrees aslant, so that no caster hides its shadow: what is at height
// z throws it z to the right. Along x the disc is stretched by sqrt 2, along y it is not.
static Scene lit_wall(void) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-6, 0, 6), vec3_make(0, 0, 0), 0, map_half_size, 1, 14);
    return scene;
}

// A plate whose upper edge y = 0 is a border of texels, so that each tap is right. At the height y = t R a
// share V(t) = 1/2 + (t sqrt(1 - t^2) + asin t) / pi of the disc is lit. A row of pixels that is a whole
// number of patterns long averages n = 32 * 32 samples. Were they independent, its standard deviation would
// be sqrt(V (1 - V) / n); one sample to a cell can only lessen it, so each row must lie within four of these
// (and the picture's half step of 255), and all rows together must be nearer than independent samples would.
static void test_edge(void **unused) {
    (void)unused;
    const int first_column = SIZE / 2 - 3 * PATTERN, columns = 5 * PATTERN, n = PATTERN * SAMPLES;
    Scene scene = lit_wall();
    closed_add(&scene, SHAPE_BOX, vec3_make(-3.6f, -2, 3), vec3_make(2.4f, 2, 0.01f), 0);
    Image image = draw(&scene, false);
    double unit = closed_unit(&scene, SIZE), ratios = 0;
    int rows = 0;
    for (int row = 0; row < SIZE; row++) {
        double t = (SIZE / 2.0 - row - 0.5) * unit / radius, measured = 0;
        if (fabs(t) >= 1)
            continue;
        for (int x = first_column; x < first_column + columns; x++)
            measured += lit_at(&image, x, row) / columns;
        double expected = prediction_answer(LAB_ID, 0, (const double[4]){t});
        double deviation = sqrt(expected * (1 - expected) / n), error = measured - expected;
        if (fabs(error) > 4 * deviation + 0.5 / 255)
            print_message("t = %.3f: expected %.4f, measured %.4f\n", t, expected, measured);
        assert_true(fabs(error) <= 4 * deviation + 0.5 / 255);
        ratios += error * error / (deviation * deviation);
        rows++;
    }
    image_destroy(&image);
    print_message("edge: %d rows, noise %.2f of that of independent samples\n", rows, sqrt(ratios / rows));
    assert_true(rows > 60 && sqrt(ratios / rows) < 1);
}

// Mean visibility of the pixels within `reach` of the middle of the sphere's shadow, and their number.
static double mean_lit(const Scene *scene, bool early_out, double middle_x, double reach, int *pixels) {
    Image image = draw(scene, early_out);
    double unit = closed_unit(scene, SIZE), sum = 0;
    *pixels = 0;
    for (int row = 0; row < SIZE; row++)
        for (int column = 0; column < SIZE; column++) {
            double x = (column + 0.5 - SIZE / 2.0) * unit - middle_x, y = (SIZE / 2.0 - row - 0.5) * unit;
            if (x * x / 2 + y * y > reach * reach)
                continue;
            sum += lit_at(&image, column, row);
            ++*pixels;
        }
    image_destroy(&image);
    return sum / *pixels;
}

// A sphere of radius b < sqrt(3/4) R. Of 4 x 8 cells the first eight samples are the two outer rows, with a
// distance from sqrt(3/4) R to R. Where the middle of the shadow is nearer than sqrt(3/4) R - b (less a
// texel) none of the eight falls on it, and the early-out calls the point wholly lit. Without the early-out V
// is 1 - (b/R)^2. The mesh is inscribed in the sphere: its silhouette, about a 32-gon, has up to 1.3 % less
// area, and a quarter of a texel along its outline is uncertain; noise as above, for samples that are all
// different.
static void check_blocker(float b) {
    const double height = 2.5, texel = 2 * map_half_size / MAP;
    const double share = 1 - prediction_answer(LAB_ID, 2, (const double[4]){b / radius});
    Scene scene = lit_wall();
    closed_add(&scene, SHAPE_SPHERE, vec3_make(-2, 0, (float)height), vec3_make(b, b, b), 0);
    int pixels;
    double reach = prediction_answer(LAB_ID, 1, (const double[4]){ROWS}) * radius - b - texel;
    double hasty = mean_lit(&scene, true, height - 2, reach, &pixels);
    double thorough = mean_lit(&scene, false, height - 2, reach, &pixels);
    double noise = 4 * sqrt(share * (1 - share) / (pixels * SAMPLES));
    double outline = 2 * b * texel / 4 / (radius * radius);
    print_message(
        "blocker of %.2f R: %.4f with early-out; without expected %.4f, measured %.4f (%d pixels)\n",
        b / radius, hasty, 1 - share, thorough, pixels);
    assert_true(pixels > 100 && hasty == 1);
    assert_true(thorough > 1 - share - noise - outline && thorough < 1 - 0.987 * share + noise + outline);
}

static void test_blocker(void **unused) {
    (void)unused;
    check_blocker(0.3f * radius);
    check_blocker(0.6f * radius);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_edge), cmocka_unit_test(test_blocker)};
    return cmocka_run_group_tests_name("witness 06", tests, NULL, NULL);
}
