// What varies from exam to exam, and what a rubric may ask to vary.
#include "exam/exam_draw.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { SEEDS = 200 };

static const Rubric rubric = {
    .id = "03",
    .check_count = 2,
    .checks = {{.view = "picture",
                .scene = "table sun",
                .scenes = {"table sun", "table spot"},
                .scene_count = 2,
                .knobs = {{.name = "list", .choices = {10, 20, 30}, .choice_count = 3},
                          {.name = "pair", .choices = {1, 2}, .choice_count = 2},
                          {.name = "whole", .low = 3, .high = 5, .whole = true},
                          {.name = "part", .low = 0.25F, .high = 0.5F}},
                .knob_count = 4},
               {.view = "picture", .scenes = {"table sun"}, .scene_count = 1, .large = true}}};

static void test_sizes(void **unused) {
    (void)unused;
    int upright = 0, wide = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        const Draw plain = draw_begin_check(&rubric, seed, 0), large = draw_begin_check(&rubric, seed, 1);
        assert_true(plain.width % 8 && plain.height % 8 && large.width % 8 && large.height % 8);
        assert_in_range(plain.width * plain.height, 13000, 31500);
        assert_true(large.width > 640 && large.height > 480);
        upright += plain.width < plain.height;
        wide += plain.width > 1.6 * plain.height;
    }
    assert_true(upright > SEEDS / 10 && wide > SEEDS / 10);
}

// Three variants see all of a list of three; lists walk together; ranges keep to their ends and reach them.
static void test_knobs(void **unused) {
    (void)unused;
    static Request request;
    bool seen[6] = {false};
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        Draw draw = draw_begin_check(&rubric, seed, 0);
        float sum = 0;
        for (int n = 0; n < 3; n++) {
            assert_true(draw_request(&draw, &request, &rubric.checks[0], n));
            bool sun = request.scene.lights[0].kind == LIGHT_DIRECTIONAL;
            assert_true(sun == (request.knobs[1].value == 1));
            assert_true(sun == (strcmp(draw_scene_name(&draw, &rubric.checks[0], n), "table sun") == 0));
            assert_in_range((int)request.knobs[2].value, 3, 5);
            seen[(int)request.knobs[2].value] = true;
            assert_true(request.knobs[3].value >= 0.25F && request.knobs[3].value < 0.5F);
            sum += request.knobs[0].value;
        }
        assert_true(sum == 60);
    }
    assert_true(seen[3] && seen[4] && seen[5]);
}

static void test_same_seed(void **unused) {
    (void)unused;
    static Request a, b;
    for (uint64_t seed = 1; seed <= 3; seed++) {
        Draw one = draw_begin_check(&rubric, seed, 0), two = draw_begin_check(&rubric, seed, 0);
        memset(&a, 0, sizeof a);
        memset(&b, 0, sizeof b);
        assert_true(draw_request(&one, &a, &rubric.checks[0], 0) &&
                    draw_request(&two, &b, &rubric.checks[0], 0));
        assert_memory_equal(&a.knobs, &b.knobs, sizeof a.knobs);
        assert_memory_equal(&a.scene.camera, &b.scene.camera, sizeof a.scene.camera);
        assert_true(draw_request(&one, &a, &rubric.checks[0], 0));
        assert_memory_not_equal(&a.scene.camera, &b.scene.camera, sizeof a.scene.camera);
    }
}

static void assert_finite(mat4s matrix) {
    for (int i = 0; i < 16; i++)
        assert_true(isfinite(matrix.raw[i / 4][i % 4]));
}

// A light or a camera that looks straight down has a view, with what it looks at in the middle.
static void test_overhead(void **unused) {
    (void)unused;
    Light light = {.kind = LIGHT_DIRECTIONAL, .half_size = 2, .near_plane = 1, .far_plane = 9, .fov_y = 1};
    light.target = vec3_make(3, 1, -2);
    for (int kind = LIGHT_SPOT; kind <= LIGHT_DIRECTIONAL; kind++)
        for (int side = -1; side <= 1; side += 2) {
            light.kind = kind;
            light.position = vec3_make(3, 1.F + 5.F * (float)side, -2);
            assert_true(light_is_overhead(&light));
            mat4s clip = light_view_from_overhead(&light);
            assert_finite(clip);
            vec3s middle = glms_mat4_mulv3(clip, light.target, 1), beside = light.target;
            beside.x += 1;
            assert_true(fabsf(middle.x) < 1e-5F && fabsf(middle.y) < 1e-5F);
            assert_true(fabsf(glms_mat4_mulv3(clip, beside, 1).x) > 0.1F);
        }
    light.position.x += 0.5F;
    assert_false(light_is_overhead(&light));
    assert_finite(camera_view_from_world(&(Camera){.eye = vec3_make(0, 4, 0), .target = vec3_make(0, 0, 0)}));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sizes), cmocka_unit_test(test_knobs),
                                       cmocka_unit_test(test_same_seed), cmocka_unit_test(test_overhead)};
    return cmocka_run_group_tests_name("draw", tests, NULL, NULL);
}
