// The stencil counts of lab 07's solution against areas and counts worked out by hand, and the adjacency they
// rest on.
#include "scene/adjacency.h"
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 800, PLATES = 3 };

// The area of the wall, in world units, that has each count from 0 to 3 (grey levels of a quarter), from
// `first_column` of the picture on.
static void measure(double area[4], const Scene *scene, float method, int first_column) {
    const WitnessKnob knob = {"method", method};
    Image image = witness_draw(LAB_ID, scene, "stencil counts", SIZE, SIZE, &knob, 1);
    double unit = closed_unit(scene, SIZE);
    for (int count = 0; count < 4; count++)
        area[count] = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        const uint8_t *pixel = image.rgba + 4 * (size_t)i;
        assert_true(pixel[0] == pixel[2] && pixel[0] < 250); // neither negative nor above 3
        if (i % SIZE >= first_column)
            area[(pixel[0] + 32) / 64] += unit * unit;
    }
    image_destroy(&image);
}

// Three square plates, each on the ray from a lamp at height H to the point `aim` of the wall, at the
// fractions t of its length: their shadows are squares of side a / t around that point, with the areas 9, 4
// and 1. They lie in each other, so the counts are 1, 2 and 3 in the area 9 - 4, 4 - 1 and 1. The plates are
// 0.0004 thick, which adds less than 0.01; each outline, 4 times the side, is uncertain by half a pixel
// (0.0046).
static void test_nested(void **unused) {
    (void)unused;
    const vec3s lamp = vec3_make(-3, 0, 4), aim = vec3_make(1.9f, 0, 0);
    const float t[PLATES] = {0.3f, 0.4f, 0.5f}, side[PLATES + 1] = {3, 2, 1, 0}, thickness = 0.0002f;
    Scene scene = closed_wall(6, 10, glm_rad(40));
    for (int i = 0; i < PLATES; i++)
        closed_add(&scene, SHAPE_BOX, glms_vec3_lerp(lamp, aim, t[i]),
                   vec3_make(side[i] * t[i] / 2, side[i] * t[i] / 2, thickness), 0);
    closed_light(&scene, LIGHT_SPOT, lamp, aim, glm_rad(90), 0, 1, 8);
    for (int method = 0; method < 2; method++) {
        double area[4];
        measure(area, &scene, (float)method, SIZE / 2); // the plates end left of it
        for (int i = 0; i < PLATES; i++) {
            double expected = side[i] * side[i] - side[i + 1] * side[i + 1];
            double tolerance = 4 * (side[i] + side[i + 1]) * closed_unit(&scene, SIZE) / 2 + 0.01;
            print_message("method %d, count %d: expected %.3f, measured %.3f\n", method, i + 1, expected,
                          area[i + 1]);
            assert_true(fabs(area[i + 1] - expected) < tolerance);
        }
    }
}

// Parallel light, a plate behind the camera that shades all that is seen, and a square plate of side 1 beside
// the picture whose shadow falls into it: count 2 on the area 1, count 1 on the rest. Z-pass does not know
// that the eye stands in a volume and counts one less everywhere.
static void test_eye_inside(void **unused) {
    (void)unused;
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 14), vec3_make(20, 20, 0.1f), 0);
    closed_add(&scene, SHAPE_BOX, vec3_make(-2, 0, 6), vec3_make(0.5f, 0.5f, 0.0002f), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-4, 0, 12), vec3_make(0, 0, 0), 0, 10, 1, 20);
    double unit = closed_unit(&scene, SIZE), all = unit * unit * SIZE * SIZE,
           tolerance = 4 * unit / 2 + 0.001;
    double fail[4], pass[4];
    measure(fail, &scene, 1, 0);
    measure(pass, &scene, 0, 0);
    print_message("z-fail: %.3f %.3f %.3f of %.3f\n", fail[0], fail[1], fail[2], all);
    print_message("z-pass: %.3f %.3f %.3f\n", pass[0], pass[1], pass[2]);
    const int by_fail = (int)prediction_answer(LAB_ID, 1, (const double[4]){1, 1, 0}); // around, in, out
    const int by_pass = (int)prediction_answer(LAB_ID, 0, (const double[4]){1, 1, 0});
    assert_true(fabs(fail[by_fail] - 1) < tolerance && fabs(fail[by_fail - 1] - (all - 1)) < tolerance);
    assert_true(fabs(pass[by_pass] - 1) < tolerance && fabs(pass[by_pass - 1] - (all - 1)) < tolerance);
}

// A closed mesh has no open edge; across the edges of a triangle lie corners that are none of its own. A
// square plane of two triangles has its four sides open.
static void test_adjacency(void **unused) {
    (void)unused;
    const int open_edges[SHAPE_COUNT] = {[SHAPE_PLANE] = 4, [SHAPE_BOX] = 0, [SHAPE_SPHERE] = 0};
    for (int shape = 0; shape < SHAPE_COUNT; shape++) {
        Mesh mesh;
        Adjacency adjacency;
        assert_true(mesh_create(&mesh, (Shape)shape) && adjacency_create(&adjacency, &mesh));
        assert_int_equal(adjacency.index_count, 2 * mesh.index_count);
        assert_int_equal(adjacency.open_edges, open_edges[shape]);
        int own = 0;
        for (int i = 1; i < adjacency.index_count; i += 2) {
            const uint32_t *triangle = adjacency.indices + i - i % 6;
            own += adjacency.indices[i] == triangle[0] || adjacency.indices[i] == triangle[2] ||
                   adjacency.indices[i] == triangle[4];
        }
        assert_int_equal(own, open_edges[shape]);
        adjacency_destroy(&adjacency);
        mesh_destroy(&mesh);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_adjacency), cmocka_unit_test(test_nested),
                                       cmocka_unit_test(test_eye_inside)};
    return cmocka_run_group_tests_name("witness 07", tests, NULL, NULL);
}
