// The baked values of lab 08's solution against closed forms of cosine-weighted occlusion (they stand at each
// test).
//
// n rays of which a share p hits have at most the standard deviation s = sqrt(p (1 - p) / n): that of
// independent rays, which the shifted even points do not exceed. A texel may be off by 5 s, the mean error of
// N texels, whose shifts are independent, by 4 s / sqrt(N). To both come half a step of the 8 bits of the
// picture and RAY_OFFSET's effect.
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include "scene/atlas.h"
#include "scene/ray.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#define DENSITY 4.0f
static const double STEP = 0.5 / 255 + 2 * RAY_OFFSET;

typedef double (*Expected)(double x, double z);

static Scene floor_scene(float half) {
    Scene scene = {.camera = {.eye = vec3_make(0, 5, 5), .fov_y = 1, .near_plane = 1, .far_plane = 20}};
    closed_add(&scene, SHAPE_PLANE, vec3_make(0, 0, 0), vec3_make(half, 1, half), 0);
    return scene;
}

// Holds each texel of the floor (the first object) against `expected`; NAN: not this one.
static void compare(const char *name, const Scene *scene, int rays, float ray_length, Expected expected) {
    Atlas atlas = {0};
    assert_true(atlas_layout(&atlas, scene, DENSITY, 1));
    const Chart *chart = &atlas.charts[0];
    const WitnessKnob knobs[] = {
        {"texel density", DENSITY}, {"rays", (float)rays}, {"ray length", ray_length}};
    Image image = witness_draw(LAB_ID, scene, "baked occlusion", atlas.width, atlas.height, knobs, 3);
    double half = scene->objects[0].world_from_object.raw[0][0], sum = 0, variance = 0;
    int count = 0;
    for (int j = 0; j < chart->height; j++)
        for (int i = 0; i < chart->width; i++) {
            double x = half * (2 * (i + 0.5) / chart->width - 1),
                   z = half * (1 - 2 * (j + 0.5) / chart->height);
            double p = expected(x, z);
            int row = atlas.height - 1 - chart->bottom - j;
            double measured = image.rgba[4 * (row * atlas.width + chart->left + i)] / 255.0;
            if (isnan(p))
                continue;
            double s = prediction_answer(LAB_ID, 2, (const double[4]){p, rays});
            assert_true(fabs(measured - p) < 5 * s + STEP);
            sum += measured - p;
            variance += s * s;
            count++;
        }
    print_message("%s: %d texels, mean error %.5f\n", name, count, sum / count);
    assert_true(count > 0 && fabs(sum / count) < 4 * sqrt(variance) / count + STEP);
    image_destroy(&image);
    atlas_destroy(&atlas);
}

// A long wall. Its ends, 40 units away, hide less than 1e-4 more or less.
static double behind_wall(double x, double z) {
    (void)x;
    return prediction_answer(LAB_ID, 0, (const double[4]){1, z + 2});
}

// Rays of the length R before a wall higher than R: (acos c - c sqrt(1 - c^2)) / pi, c = x / R.
static double behind_limit(double x, double z) {
    (void)x;
    double c = fmin((z + 2) / 0.9, 1);
    return (acos(c) - c * sqrt(1 - c * c)) / GLM_PI;
}

static void test_wall(void **unused) {
    (void)unused;
    Scene scene = floor_scene(2);
    closed_stand(&scene, vec3_make(0, 0.5f, -2), 40, 0.5f, 0);
    compare("wall", &scene, 1024, 100, behind_wall);
    compare("wall, short rays", &scene, 1024, 0.9f, behind_limit);
}

// Lambert's edge sum for a rectangle on the floor's side of the horizon, seen from p on the floor.
static double rectangle(vec3s p, const vec3s corners[4]) {
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        vec3s a = glms_vec3_normalize(glms_vec3_sub(corners[i], p));
        vec3s b = glms_vec3_normalize(glms_vec3_sub(corners[(i + 1) % 4], p));
        vec3s across = glms_vec3_normalize(glms_vec3_cross(a, b));
        sum += acos(glms_vec3_dot(a, b)) * across.y;
    }
    return fabs(sum) / (2 * GLM_PI);
}

// Two walls, 8 long and 4 high, that meet over the corner (-1, -1).
static double in_corner(double x, double z) {
    vec3s p = vec3_make((float)x, 0, (float)z);
    const vec3s back[4] = {vec3_make(-1, 0, -1), vec3_make(7, 0, -1), vec3_make(7, 4, -1),
                           vec3_make(-1, 4, -1)};
    const vec3s left[4] = {vec3_make(-1, 0, -1), vec3_make(-1, 0, 7), vec3_make(-1, 4, 7),
                           vec3_make(-1, 4, -1)};
    return rectangle(p, back) + rectangle(p, left);
}

// The edge sum agrees with 3/4 close to the corner, where the walls are as good as infinite.
static void test_corner(void **unused) {
    (void)unused;
    assert_true(fabs(in_corner(-0.999, -0.999) - 0.75) < 1e-3);
    Scene scene = floor_scene(1);
    closed_stand(&scene, vec3_make(3, 2, -1), 4, 2, 0);
    closed_stand(&scene, vec3_make(-1, 2, 3), 4, 2, 90);
    compare("corner", &scene, 1024, 100, in_corner);
}

// A sphere of radius r at the distance d, all of it above the horizon: (r / d)^2 cos b.
static double under_sphere(double x, double z) {
    const double r = 0.6, height = 1;
    double d_squared = x * x + z * z + height * height;
    return r * r / d_squared * height / sqrt(d_squared);
}

// A disc of radius R at the height h, on its axis: R^2 / (R^2 + h^2).
static double under_disc(double x, double z) {
    const double radius = 0.7, height = 0.5;
    return fabs(x) + fabs(z) < 1e-6 ? prediction_answer(LAB_ID, 1, (const double[4]){radius, height}) : NAN;
}

static void test_sphere_and_disc(void **unused) {
    (void)unused;
    Scene scene = floor_scene(2);
    closed_add(&scene, SHAPE_SPHERE, vec3_make(0, 1, 0), vec3_make(0.6f, 0.6f, 0.6f), 0);
    compare("sphere", &scene, 2048, 100, under_sphere);
    scene = floor_scene(0.875f); // 7 x 7 texels: one has its middle on the axis
    closed_add(&scene, SHAPE_SPHERE, vec3_make(0, 0.5f, 0), vec3_make(0.7f, 1e-3f, 0.7f), 0);
    compare("disc", &scene, 4096, 100, under_disc);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_wall), cmocka_unit_test(test_corner),
                                       cmocka_unit_test(test_sphere_and_disc)};
    return cmocka_run_group_tests_name("witness 08", tests, NULL, NULL);
}
