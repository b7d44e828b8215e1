// The shadows of lab 03's solution against closed forms (they stand at each test).
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 800, MAP = 2048 };

static double shadow_area(const Scene *scene, int first_column) {
    const WitnessKnob map = {"map size", MAP};
    Image image = witness_draw(LAB_ID, scene, "visibility", SIZE, SIZE, &map, 1);
    int dark = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = first_column; x < SIZE; x++)
            dark += image.rgba[4 * (y * SIZE + x)] < 128;
    image_destroy(&image);
    double unit = closed_unit(scene, SIZE);
    return dark * unit * unit;
}

// A point light at height H over a plane, a sphere of radius r at distance d whose direction is tilted by
// theta from the normal: the shadow is an ellipse with the half axes H sin a cos a / Q and H sin a / sqrt Q,
// sin a = r / d, Q = cos^2 theta - sin^2 a. The mesh is inscribed in the sphere: its silhouette, about a
// 32-gon, has up to 1.3 % less area. The map's texel (8 units / 2048) may add or take a quarter of itself
// along the outline (about 5 units): 0.5 %.
static void test_sphere(void **unused) {
    (void)unused;
    const float light_height = 4, r = 0.5f;
    const vec3s light = vec3_make(-3.5f, 0, light_height), center = vec3_make(-1.5f, 0, 1.6f);
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_SPHERE, center, vec3_make(r, r, r), 0);
    closed_light(&scene, LIGHT_SPOT, light, vec3_make(0, 0, 0), glm_rad(80), 0, 1, 8);
    double d = glms_vec3_distance(light, center), sin_a = r / d, cos_a = sqrt(1 - sin_a * sin_a);
    double cos_theta = (light.z - center.z) / d, q = cos_theta * cos_theta - sin_a * sin_a;
    double expected = GLM_PI * (light_height * sin_a * cos_a / q) * (light_height * sin_a / sqrt(q));
    double measured = shadow_area(&scene, SIZE * 34 / 100); // the sphere itself ends left of it
    print_message("sphere: expected %.4f, measured %.4f\n", expected, measured);
    assert_true(measured > expected * (1 - 0.018) && measured < expected * 1.005);
}

// A square of side a, parallel to the plane at height h, under a point light at height H: a square of area
// a^2 (H / (H - h))^2. Here a box so flat (0.002) that its sides
// add 0.006. Outline 4 * 2 units, a quarter of a texel (0.004) and half a
// pixel (0.005) of uncertainty along it: 0.03 of 4.
static void test_square(void **unused) {
    (void)unused;
    const float light_height = 4, h = 2, side = 1, thickness = 0.001f;
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, vec3_make(-0.9f, 0, h - thickness),
               vec3_make(side / 2, side / 2, thickness), 0);
    closed_light(&scene, LIGHT_SPOT, vec3_make(-3, 0, light_height), vec3_make(1.2f, 0, 0), glm_rad(90), 0, 1,
                 8);
    double width = prediction_answer(LAB_ID, 1, (const double[4]){side, h, light_height});
    double expected = width * width;
    double measured = shadow_area(&scene, SIZE / 2);
    print_message("square: expected %.4f, measured %.4f\n", expected, measured);
    assert_true(fabs(measured - expected) < 0.04);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sphere), cmocka_unit_test(test_square)};
    return cmocka_run_group_tests_name("witness 03", tests, NULL, NULL);
}
