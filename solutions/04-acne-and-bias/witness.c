// Acne, gap and normal offset of lab 04's solution against closed forms (they stand at each test). The light
// is directional and tilted from the wall's normal in the plane of x and z, so that all rows of the picture
// are alike.
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 800 };
static const float NEAR = 4, FAR = 16;

// A wall seen straight on under a light at the angle `theta`, with a map 2 * half_size wide.
static Scene tilted_light(double theta, float half_size) {
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-10 * sinf((float)theta), 0, 10 * cosf((float)theta)),
                 vec3_make(0, 0, 0), 0, half_size, NEAR, FAR);
    return scene;
}

// Number of lit pixels in the middle row between two places on the wall, in world units from the middle.
static int lit_between(const Image *image, const Scene *scene, double left, double right) {
    double unit = closed_unit(scene, SIZE);
    int lit = 0;
    for (int x = 0; x < SIZE; x++) {
        double place = (x + 0.5 - SIZE / 2) * unit;
        lit += place > left && place < right && image->rgba[4 * (SIZE / 2 * SIZE + x)] > 127;
    }
    return lit;
}

// A bare wall under a light at the angle theta shows acne on the share (1 - r) / 2 for r = b / b0 < 1, where
// b0 = s tan theta / 2 and s is the texel; on none of it for r > 1. Whole texels are counted, so that only
// the pixels at the ends of each dark run are in doubt: less than one for each run, and one for the ends of
// the row.
static void test_acne_share(void **unused) {
    (void)unused;
    enum { MAP = 64, TEXELS = 6 };
    const double theta = glm_rad(60), texel = 32.0 / MAP, width = TEXELS * texel / cos(theta);
    const double least_bias = prediction_answer(LAB_ID, 0, (const double[4]){MAP, 32, FAR - NEAR, 60});
    const Scene scene = tilted_light(theta, 16);
    const double ratios[] = {0, 0.25, 0.5, 0.75, 1.02};
    for (int i = 0; i < 5; i++) {
        const WitnessKnob knobs[] = {
            {"method", 1}, {"map size", MAP}, {"bias", (float)(ratios[i] * least_bias)}};
        Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 3);
        double pixels = width / closed_unit(&scene, SIZE);
        double share = 1 - lit_between(&image, &scene, -width / 2, width / 2) / pixels;
        double expected = fmax((1 - ratios[i]) / 2, 0);
        print_message("acne at r = %.2f: expected %.4f, measured %.4f\n", ratios[i], expected, share);
        assert_true(fabs(share - expected) < (TEXELS + 1) / pixels);
        image_destroy(&image);
    }
}

// A board across the light stands on the wall.
static const float HEIGHT = 1, HALF_THICKNESS = 0.05f, MAP_HALF_SIZE = 4;
static const double THETA = 50; // of the light, degrees

static Scene board(void) {
    Scene scene = tilted_light(glm_rad(THETA), MAP_HALF_SIZE);
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, HEIGHT / 2), vec3_make(HALF_THICKNESS, 3, HEIGHT / 2), 0);
    return scene;
}

// A depth bias b lights the foot of the board's shadow as far as b sin theta from the lit face. The map knows
// the lit face at the middle of a texel only, which moves the end by s cos theta / 2; and a pixel is in
// doubt.
static void test_gap(void **unused) {
    (void)unused;
    enum { MAP = 1024 };
    const double bias = 0.8, theta = glm_rad(THETA), texel = 2 * MAP_HALF_SIZE / MAP;
    const Scene scene = board();
    const WitnessKnob knobs[] = {{"method", 1}, {"map size", MAP}, {"bias", (float)bias / (FAR - NEAR)}};
    Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 3);
    double unit = closed_unit(&scene, SIZE), start = 0.2,
           expected =
               prediction_answer(LAB_ID, 1, (const double[4]){bias / (FAR - NEAR), FAR - NEAR, THETA}) -
               HALF_THICKNESS;
    double measured = start + lit_between(&image, &scene, start, 1.1) * unit;
    print_message("gap: expected to end at %.4f, measured %.4f\n", expected, measured);
    assert_true(fabs(measured - expected) < texel * cos(theta) / 2 + unit);
    image_destroy(&image);
}

// A normal offset d leaves no gap there, but takes d tan theta from the tip of the shadow, which would lie at
// HEIGHT tan theta from the dark face. Half a texel, s / (2 cos theta) on the wall, and a pixel are in doubt.
static void test_normal_offset(void **unused) {
    (void)unused;
    enum { MAP = 256, OFFSET = 8 };
    const double theta = glm_rad(THETA), texel = 2 * MAP_HALF_SIZE / MAP;
    const Scene scene = board();
    const WitnessKnob knobs[] = {{"method", 5}, {"map size", MAP}, {"normal offset", OFFSET}};
    Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 3);
    double unit = closed_unit(&scene, SIZE), end = 2.5;
    double shift = prediction_answer(LAB_ID, 2, (const double[4]){OFFSET, texel, THETA});
    double expected = HALF_THICKNESS + HEIGHT * tan(theta) - shift;
    double measured = end - lit_between(&image, &scene, 0.1, end) * unit;
    print_message("tip: expected at %.4f, measured %.4f\n", expected, measured);
    assert_int_equal(lit_between(&image, &scene, 0.07, 0.6), 0);
    assert_true(fabs(measured - expected) < texel / 2 / cos(theta) + unit);
    image_destroy(&image);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_acne_share), cmocka_unit_test(test_gap),
                                       cmocka_unit_test(test_normal_offset)};
    return cmocka_run_group_tests_name("witness 04", tests, NULL, NULL);
}
