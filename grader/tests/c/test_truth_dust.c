// The truth's dust against closed forms: one pixel of a camera at the origin that looks along -z.
#include "scene/check.h"
#include "tests/helpers/truth_points.h"
#include "truth/dust.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static const double tolerance = 2e-6;

static mat4s place(vec3s center, vec3s half_size) {
    return glms_scale(glms_translate_make(center), half_size);
}

// Sees a wall at z = -10.
static Scene wall_at_10(Medium medium) {
    Scene scene = {.camera = {.eye = {{0, 0, 0}},
                              .target = {{0, 0, -1}},
                              .fov_y = 0.1f,
                              .near_plane = 0.1f,
                              .far_plane = 14},
                   .medium = medium,
                   .light_count = 1};
    scene.lights[0] = (Light){.kind = LIGHT_DIRECTIONAL, .position = {{0, 5, -3}}, .target = {{0, 0, -3}}};
    truth_point_add(&scene, SHAPE_BOX, place(vec3_make(0, 0, -11), vec3_make(5, 5, 1)));
    return scene;
}

static double middle(const Scene *scene) {
    Truth truth;
    TruthPicture picture;
    float value[9];
    assert_true(truth_create(&truth, scene) && truth_picture_create(&picture, 3, 3));
    truth_look(&truth, &picture);
    assert_true(truth_trace(&truth, &picture, &(TruthQuery){.kind = TRUTH_DUST}, value));
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
    return (double)value[4];
}

static double between(Medium medium, double from, double to) {
    double a = medium.extinction, s = medium.scattering;
    return a > 0 ? s * (exp(-a * from) - exp(-a * to)) / a : s * (to - from);
}

static void test_media(void **unused) {
    (void)unused;
    const Medium media[] = {{0, 0}, {0.05f, 0}, {0.1f, 0.1f}, {0.3f, 0.7f}, {0, 0.4f}, {0.05f, 1e-9f}};
    for (size_t i = 0; i < sizeof media / sizeof *media; i++) {
        Scene scene = wall_at_10(media[i]);
        assert_true(fabs(middle(&scene) - between(media[i], 0, 10)) < tolerance);
        scene.object_count = 0; // up to the far plane
        assert_true(fabs(middle(&scene) - between(media[i], 0, 14)) < tolerance);
    }
}

// Under the sun straight above, plates keep it from what lies under them: once where they overlap.
static void test_plates(void **unused) {
    (void)unused;
    const Medium medium = {0.1f, 0.12f};
    Scene scene = wall_at_10(medium);
    truth_point_add(&scene, SHAPE_BOX, place(vec3_make(0, 2, -4), vec3_make(1, 0.1f, 1)));
    double whole = between(medium, 0, 10);
    assert_true(fabs(middle(&scene) - (whole - between(medium, 3, 5))) < tolerance);
    truth_point_add(&scene, SHAPE_PLANE, place(vec3_make(0, 3, -5), vec3_make(1, 1, 0.5f)));
    assert_true(fabs(middle(&scene) - (whole - between(medium, 3, 5.5))) < tolerance);
    truth_point_add(&scene, SHAPE_BOX, place(vec3_make(0, -2, -8), vec3_make(1, 0.1f, 1))); // below the ray
    assert_true(fabs(middle(&scene) - (whole - between(medium, 3, 5.5))) < tolerance);
    truth_point_add(&scene, SHAPE_BOX, place(vec3_make(0, 2, 0), vec3_make(1, 0.1f, 1))); // above the eye
    assert_true(fabs(middle(&scene) - (whole - between(medium, 0, 1) - between(medium, 3, 5.5))) < tolerance);
}

// A lamp at height 4: the shadow of a plate at height 2 is twice as large, seen from below it. A sphere's
// mesh lies between the spheres of radius r cos(pi/16) and r.
static void test_lamp(void **unused) {
    (void)unused;
    const Medium medium = {0.1f, 0.12f};
    Scene scene = wall_at_10(medium);
    scene.lights[0] = (Light){.kind = LIGHT_POINT, .position = {{0, 4, -5}}, .target = {{0, 0, -5}}};
    truth_point_add(&scene, SHAPE_PLANE, place(vec3_make(0, 2, -5), vec3_make(0.7f, 1, 0.7f)));
    double whole = between(medium, 0, 10);
    assert_true(fabs(middle(&scene) - (whole - between(medium, 5 - 1.4, 5 + 1.4))) < tolerance);
    scene.object_count--;
    truth_point_add(&scene, SHAPE_SPHERE, place(vec3_make(0, 2, -5), vec3_make(0.7f, 0.7f, 0.7f)));
    double outer = 4 * 0.7 / sqrt(4 - 0.49), inner = 4 * 0.686 / sqrt(4 - 0.686 * 0.686),
           dark = whole - middle(&scene);
    assert_true(dark < between(medium, 5 - outer, 5 + outer) + tolerance);
    assert_true(dark > between(medium, 5 - inner, 5 + inner) - tolerance);
}

// Behind a spot light it is dark, whichever way it looks along the ray.
static void test_spot(void **unused) {
    (void)unused;
    const Medium medium = {0.1f, 0.12f};
    Scene scene = wall_at_10(medium);
    for (int side = -1; side <= 1; side += 2) {
        scene.lights[0] =
            (Light){.kind = LIGHT_SPOT, .position = {{0, 1, -3}}, .target = {{0, 1, (float)side - 3}}};
        double lit = side < 0 ? between(medium, 3, 10) : between(medium, 0, 3);
        assert_true(fabs(middle(&scene) - lit) < tolerance);
    }
    scene.lights[0].target = vec3_make(0, 5, -3); // away from the ray
    assert_true(middle(&scene) == 0);
}

static void test_refusals(void **unused) {
    (void)unused;
    const Medium media[] = {{-0.1f, 0}, {0, -0.1f}, {NAN, 0}, {0, INFINITY}};
    for (size_t i = 0; i < sizeof media / sizeof *media; i++) {
        check_clear();
        assert_false(medium_check(&media[i]));
        assert_non_null(strstr(check_message(), "medium"));
    }
    Scene scene = wall_at_10(media[0]);
    Truth truth;
    TruthPicture picture;
    float value[9];
    assert_true(truth_create(&truth, &scene) && truth_picture_create(&picture, 3, 3));
    assert_false(truth_trace(&truth, &picture, &(TruthQuery){.kind = TRUTH_DUST}, value));
    assert_false(truth_trace(&truth, &picture, &(TruthQuery){.kind = TRUTH_DUST, .light = 1}, value));
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_media), cmocka_unit_test(test_plates),
                                       cmocka_unit_test(test_lamp), cmocka_unit_test(test_spot),
                                       cmocka_unit_test(test_refusals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
