// The penumbrae of lab 05's solution against closed forms (they stand at each test).
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 640, BY_HAND = 1, LINEAR, DIAGONALS, BOX, GATHER };

static const float distance = 10, map_half_size = 4;

static Image draw(const Scene *scene, int method, int radius, int map_size) {
    const WitnessKnob knobs[] = {
        {"method", (float)method}, {"kernel radius", (float)radius}, {"map size", (float)map_size}};
    return witness_draw(LAB_ID, scene, "visibility", SIZE, SIZE, knobs, 3);
}

static double lit_at(const Image *image, int x, int y) {
    return image->rgba[4 * (y * SIZE + x)] / 255.0;
}

// Visibility beside a straight edge at 0 that lies between two columns of texels, x in texels: each linear
// comparison is a ramp one texel wide, and the method takes the mean of such ramps.
static double expected_lit(int method, int radius, double x) {
    const double ramp =
        prediction_answer(LAB_ID, 0, (const double[4]){128, 128, radius}); // a texel is 1 wide
    const double width = method == LINEAR ? 1 : method == GATHER ? 3 : ramp;
    if (method == BY_HAND) // columns floor(x) - 1 .. floor(x) + 1; those from 0 on are lit
        return fmin(fmax(floor(x) + 2, 0), 3) / 3;
    if (method == DIAGONALS)
        return (expected_lit(LINEAR, 0, x - 1) + expected_lit(LINEAR, 0, x + 1)) / 2;
    if (method == GATHER && fabs(x) < 0.5) // as three comparisons on lit, lit, dark, dark
        return prediction_answer(LAB_ID, 2, (const double[4]){0.5 - x});
    return fmin(fmax(0.5 + x / width, 0), 1);
}

// A plate before a wall, light and eye straight on. The plate's right edge, at x = -1, lies on a border of
// texels (one is 8 / 128 wide). Each pixel of the middle row that shows the penumbra is compared: a picture
// has 255 steps, and a driver may round the weight of a linear filter to 1/256, so two steps are allowed.
// Pixels within a hundredth of a texel of a jump are left out. The L1 error, the area between the profile and
// the hard edge, is w/4 for a box of width w; its sum over pixels has the same relative uncertainty of two
// steps.
static void check_profile(int method, int radius) {
    const double edge = -1, texel = 2 * map_half_size / 128;
    Scene scene = closed_wall(6, distance, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, vec3_make(-2, 0, 2), vec3_make(1, 2, 0.001f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, 8), vec3_make(0, 0, 0), 0, map_half_size, 1, 10);
    Image image = draw(&scene, method, radius, 128);
    double unit = closed_unit(&scene, SIZE), sum = 0, largest = 0;
    for (int column = 0; column < SIZE; column++) {
        double x = ((column + 0.5 - SIZE / 2.0) * unit - edge) / texel;
        if (fabs(x) > 3.9) // the plate hides what lies more than 4 texels to the left
            continue;
        double lit = lit_at(&image, column, SIZE / 2);
        sum += fabs(lit - (x > 0)) * unit / texel;
        if (method != BY_HAND || fabs(x - round(x)) > 0.01)
            largest = fmax(largest, fabs(lit - expected_lit(method, radius, x)));
    }
    image_destroy(&image);
    print_message("method %d, radius %d: off by %.4f; L1 error %.4f texels\n", method, radius, largest, sum);
    assert_true(largest <= 2 / 255.0);
    if (method == BOX)
        assert_true(fabs(sum - (2 * radius + 1) / 4.0) <= (2 * radius + 1) * 2 / 255.0);
}

static void test_profile(void **unused) {
    (void)unused;
    check_profile(BY_HAND, 0);
    check_profile(LINEAR, 0);
    check_profile(DIAGONALS, 0);
    check_profile(GATHER, 0);
    for (int radius = 0; radius <= 3; radius++)
        check_profile(BOX, radius);
}

// The larger distance along x or y.
static double away_from(double x, double y, vec3s center) {
    return fmax(fabs(x - center.x), fabs(y - center.y));
}

// A slanting light, a square of side 1 parallel to the wall at height h. Where nothing is in the way every
// pixel must be fully lit, for every kernel: the bias reaches as far as the taps. A mean over neighbours
// moves shadow but makes none, so that the sum of 1 - V is the area of the square. The map may make it one
// texel wider or narrower in each direction (8 / 512, which a slanting light draws out to 1 / cos as much),
// the picture half a pixel.
static void check_slanting(vec3s light, int radius) {
    const float h = 1.5f;
    vec3s to_light = glms_vec3_normalize(light), center = vec3_make(to_light.x, to_light.y, h);
    vec3s shadow = glms_vec3_sub(center, glms_vec3_scale(to_light, h / to_light.z));
    vec3s seen =
        glms_vec3_scale(center, distance / (distance - h)); // where the eye sees the square on the wall
    Scene scene = closed_wall(3, distance, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, center, vec3_make(0.5f, 0.5f, 0.001f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, glms_vec3_scale(to_light, 9), vec3_make(0, 0, 0), 0,
                 map_half_size, 2, 16);
    Image image = draw(&scene, BOX, radius, 512);
    double unit = closed_unit(&scene, SIZE), texel = 2 * map_half_size / 512 / to_light.z, area = 0;
    int acne = 0;
    for (int row = 0; row < SIZE; row++)
        for (int column = 0; column < SIZE; column++) {
            double x = (column + 0.5 - SIZE / 2.0) * unit, y = (SIZE / 2.0 - row - 0.5) * unit;
            if (away_from(x, y, vec3_make(0, 0, 0)) > 2.9 || away_from(x, y, seen) < 0.62)
                continue; // past the end of the wall, or on the square
            double dark = 1 - lit_at(&image, column, row);
            area += dark * unit * unit;
            acne += dark > 0 && away_from(x, y, shadow) > 0.5 + (radius + 2) * texel;
        }
    image_destroy(&image);
    print_message("slanting, radius %d: %d pixels of acne, area %.4f\n", radius, acne, area);
    assert_int_equal(acne, 0);
    assert_true(fabs(area - 1) <= 2 * (texel + unit / 2));
}

static void test_slanting(void **unused) {
    (void)unused;
    for (int radius = 0; radius <= 7; radius += 1 + radius / 2) {
        check_slanting(vec3_make(1, 0, 1), radius);
        check_slanting(vec3_make(0.8f, 0.75f, 1), radius);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_profile), cmocka_unit_test(test_slanting)};
    return cmocka_run_group_tests_name("witness 05", tests, NULL, NULL);
}
