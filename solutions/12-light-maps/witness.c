// Lab 12's luxels and pictures against closed forms: the light of a lamp, the solid angle of a rectangle,
// segments cut by hand, the shadow of a ball.
#include "scene/atlas.h"
#include "scene/check.h"
#include "scene/count.h"
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#define STEP (0.5 / 255) // of the picture's bytes, rounded
#define HALF 0x1p-11     // relative, of a half float

enum { SIZE = 240 };
static const vec3s lamp = {{0.4f, -0.3f, 2}};

// A wall with a lamp of so much light before it.
static Scene lit_wall(float half_size, LightKind kind, vec3s place, float bright) {
    Scene scene = closed_wall(half_size, 10, glm_rad(30));
    closed_light(&scene, kind, place, vec3_make(place.x - 0.3f, place.y, 0), 1, 5, 0.5f, 20);
    scene.lights[0].color = vec3_make(bright, bright, bright);
    return scene;
}

// Turns the wall and the lamp together, and moves them: the light stays the same.
static void turn_all(Scene *scene, mat4s turn) {
    Light *light = &scene->lights[0];
    scene->objects[0].world_from_object = glms_mat4_mul(turn, scene->objects[0].world_from_object);
    light->position = glms_mat4_mulv3(turn, light->position, 1);
    light->target = glms_mat4_mulv3(turn, light->target, 1);
}

// A stage of the lab, one pixel a luxel, and the atlas that it belongs to.
typedef struct Luxels {
    Atlas atlas;
    Image image;
    float density;
} Luxels;

static Luxels luxels_draw(const Scene *scene, const char *stage, float density, const WitnessKnob *knobs,
                          int knob_count) {
    Luxels luxels = {.density = density};
    WitnessKnob all[8] = {{"luxel density", density}};
    for (int i = 0; i < knob_count; i++)
        all[i + 1] = knobs[i];
    assert_true(atlas_layout(&luxels.atlas, scene, density, 1));
    int width = luxels.atlas.width, height = luxels.atlas.height;
    if (stage[0] != 's') { // the shares have the atlas's size, the others can be halved three times
        width = (width + 7) / 8 * 8;
        height = (height + 7) / 8 * 8;
    }
    luxels.image = witness_draw(LAB_ID, scene, stage, width, height, all, knob_count + 1);
    return luxels;
}

static void luxels_destroy(Luxels *luxels) {
    atlas_destroy(&luxels->atlas);
    image_destroy(&luxels->image);
}

// What luxel (x, y) of the first chart holds.
static double luxel_at(const Luxels *luxels, int x, int y) {
    const Chart *chart = &luxels->atlas.charts[0];
    int row = luxels->image.height - 1 - chart->bottom - y;
    return luxels->image.rgba[4 * (row * luxels->image.width + chart->left + x)] / 255.0;
}

static vec3s luxel_place(const Chart *chart, int x, int y) {
    return atlas_position(chart, ((float)x + 0.5f) / (float)chart->width,
                          ((float)y + 0.5f) / (float)chart->height);
}

// color * cos / r^2, or color * cos for a sun.
static double light_at(const Scene *scene, vec3s place, vec3s normal) {
    const Light *light = &scene->lights[0];
    bool is_sun = light->kind == LIGHT_DIRECTIONAL;
    vec3s way = glms_vec3_sub(light->position, is_sun ? light->target : place);
    double r = glms_vec3_norm(way), cosine = fmax(glms_vec3_dot(way, normal) / r, 0);
    return light->color.x * cosine / (is_sun ? 1 : r * r);
}

// The solid angle of the wall [-a, a] x [-b, b] from (x, y, h): of four rectangles with a corner under the
// lamp.
static double solid_angle(double a, double b, double x, double y, double h) {
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        double u = i % 2 ? a - x : a + x, v = i / 2 ? b - y : b + y;
        sum += atan(u * v / (h * sqrt(u * u + v * v + h * h)));
    }
    return sum;
}

// Each luxel has the light of its middle. Their mean is I Omega / A: the middles of squares of side s miss
// the integral by s^2 / 24 |E_xx + E_yy| at most, and that is 6 I / h^4 under the lamp, where it is largest.
static void test_irradiance(void **unused) {
    (void)unused;
    for (int i = 0; i < 4; i++) {
        const float half = 1.5f, density = 8, bright = 3.9f;
        Scene scene = lit_wall(half, i % 2 ? LIGHT_SPOT : LIGHT_POINT, lamp, bright);
        mat4s turn = glms_rotate(glms_translate_make(vec3_make((float)i, -0.5f, 0)), 0.7f * (float)i,
                                 vec3_make(1, 2, 0.5f));
        turn_all(&scene, turn);
        const WitnessKnob knobs[] = {{"shadows", 0}};
        Luxels luxels = luxels_draw(&scene, "bare luxels", density, knobs, 1);
        const Chart *chart = &luxels.atlas.charts[0];
        double sum = 0, h = lamp.z, s = 1 / density, count = chart->width * chart->height;
        for (int k = 0; k < (int)count; k++) {
            int x = k % chart->width, y = k / chart->width;
            double measured = luxel_at(&luxels, x, y);
            double away = glms_vec3_distance(scene.lights[0].position, luxel_place(chart, x, y));
            double given[4] = {bright, h, sqrt(fmax(away * away - h * h, 0))};
            double expected = prediction_answer(LAB_ID, 0, given);
            assert_true(fabs(measured - expected) < STEP + HALF + 1e-5);
            sum += measured / count;
        }
        double mean = bright * solid_angle(half, half, lamp.x, lamp.y, h) / (4 * half * half);
        print_message("%.0f luxels, mean %.5f, by the solid angle %.5f\n", count, sum, mean);
        assert_true(fabs(sum - mean) < s * s / 4 * bright / pow(h, 4) + STEP);
        luxels_destroy(&luxels);
    }
}

// A sun has no distance, and a wall that looks away gets nothing.
static void test_sun(void **unused) {
    (void)unused;
    for (int i = -1; i <= 1; i++) {
        Scene scene = lit_wall(1, LIGHT_DIRECTIONAL, vec3_make(4, 3, 5 * (float)i), 0.9f);
        const WitnessKnob knobs[] = {{"shadows", 0}};
        Luxels luxels = luxels_draw(&scene, "bare luxels", 4, knobs, 1);
        double expected = 0.9 * fmax(5 * i, 0) / sqrt(0.3 * 0.3 + 5 * 5);
        for (int k = 0; k < 64; k++)
            assert_true(fabs(luxel_at(&luxels, k % 8, k / 8) - expected) < STEP + HALF);
        luxels_destroy(&luxels);
    }
}

// Is the way from the place to the end cut by a square plate at `center`, made larger by `margin`?
static bool is_cut(vec3s center, float half, vec3s place, vec3s end, float margin) {
    float t = (center.z - place.z) / (end.z - place.z);
    vec3s at = glms_vec3_lerp(place, end, t);
    return t > 0 && t < 1 && fabsf(at.x - center.x) < half + margin && fabsf(at.y - center.y) < half + margin;
}

// Plates before the wall, behind it and beyond the lamp: of each luxel whose middle is not within a hundredth
// of an edge the share is 0 or 1.
static void test_plates(void **unused) {
    (void)unused;
    const float heights[] = {0.3f, 1, 1.8f, 2.2f, 4, -0.5f};
    for (size_t i = 0; i < 2 * COUNT(heights); i++) {
        LightKind kind = i % 2 ? LIGHT_DIRECTIONAL : LIGHT_POINT;
        Scene scene = lit_wall(1.5f, kind, lamp, 1);
        const vec3s center = vec3_make(0.1f, 0.2f, heights[i / 2]);
        const float half = 0.3f;
        closed_add(&scene, SHAPE_BOX, center, vec3_make(half, half, 1e-5f), 0);
        Luxels luxels = luxels_draw(&scene, "shares of the lamp", 12, NULL, 0);
        vec3s along = glms_vec3_scale(glms_vec3_sub(scene.lights[0].position, scene.lights[0].target), 10);
        const Chart *chart = &luxels.atlas.charts[0];
        int dark = 0;
        for (int k = 0; k < chart->width * chart->height; k++) {
            int x = k % chart->width, y = k / chart->width;
            vec3s place = luxel_place(chart, x, y);
            vec3s end = kind == LIGHT_POINT ? lamp : glms_vec3_add(place, along);
            bool cut = is_cut(center, half, place, end, 0.01f);
            if (cut != is_cut(center, half, place, end, -0.01f))
                continue;
            dark += cut;
            assert_true(fabs(luxel_at(&luxels, x, y) - !cut) < STEP);
        }
        print_message("a plate at the height %.1f: %d dark luxels\n", heights[i / 2], dark);
        luxels_destroy(&luxels);
    }
}

// A lamp of side 2 e at the height H and an edge at the height h: in the penumbra light falls linearly over
// 2 e h / (H - h). A share p of n rays may be off by five standard deviations of independent ones, which the
// shifted even points do not exceed.
static void test_penumbra(void **unused) {
    (void)unused;
    const int rays = 256;
    Scene scene = lit_wall(1.5f, LIGHT_POINT, vec3_make(0, 0, 4), 1);
    scene.lights[0].target = vec3_make(0, 0, 0);
    scene.lights[0].extent = 0.5f;
    closed_add(&scene, SHAPE_BOX, vec3_make(-5, 0, 2), vec3_make(5, 5, 1e-5f), 0);
    const WitnessKnob knobs[] = {{"rays", (float)rays}};
    Luxels luxels = luxels_draw(&scene, "shares of the lamp", 12, knobs, 1);
    const Chart *chart = &luxels.atlas.charts[0];
    int inside = 0;
    for (int k = 0; k < chart->width * chart->height; k++) {
        int x = k % chart->width, y = k / chart->width;
        double p = fmin(fmax(luxel_place(chart, x, y).x + 0.5, 0), 1); // 1 wide, its middle at 0
        inside += p > 0 && p < 1;
        assert_true(fabs(luxel_at(&luxels, x, y) - p) < 5 * sqrt(p * (1 - p) / rays) + STEP + 2e-3);
    }
    print_message("%d luxels of penumbra\n", inside);
    assert_true(inside > 100);
    luxels_destroy(&luxels);
}

// Between the middles of the luxels light changes linearly, and beyond the outer ones not at all.
static double interpolated(const Scene *scene, double half, float density, double x, double y) {
    double sum = 0, last = 2 * half * density - 1;
    double u = fmin(fmax((x + half) * density - 0.5, 0), last),
           v = fmin(fmax((y + half) * density - 0.5, 0), last);
    for (int i = 0; i < 4; i++) {
        double a = floor(u) + i % 2, b = floor(v) + i / 2, weight = (1 - fabs(u - a)) * (1 - fabs(v - b));
        vec3s place = vec3_make((float)((a + 0.5) / density - half), (float)((b + 0.5) / density - half), 0);
        sum += weight > 0 ? weight * light_at(scene, place, vec3_make(0, 0, 1)) : 0;
    }
    return sum;
}

// The picture of a wall of colour 0.5 under the ambient light 0.25, with padding or mipmaps or both.
static void test_picture(void **unused) {
    (void)unused;
    for (int padding = 1; padding <= 4; padding++) {
        const float density = 2;
        Scene scene = lit_wall(2, LIGHT_POINT, lamp, 4);
        scene.ambient = vec3_make(0.25f, 0.25f, 0.25f);
        scene.objects[0].color = vec3_make(0.5f, 0.5f, 0.5f);
        const WitnessKnob knobs[] = {{"luxel density", density}, {"padding", (float)padding}};
        Image image = witness_draw(LAB_ID, &scene, "picture", SIZE, SIZE, knobs, 2);
        double unit = closed_unit(&scene, SIZE);
        int seen = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            double x = (i % SIZE + 0.5 - SIZE / 2) * unit,
                   y = (SIZE / 2 - 0.5 - floor((double)i / SIZE)) * unit;
            if (fabs(x) > 2 - unit || fabs(y) > 2 - unit)
                continue;
            double expected = 0.5 * (0.25 + interpolated(&scene, 2, density, x, y));
            assert_true(fabs(image.rgba[4 * i] / 255.0 - expected) < 2 * STEP + HALF);
            seen++;
        }
        print_message("padding %d: %d pixels\n", padding, seen);
        assert_true(seen > 1000);
        image_destroy(&image);
    }
}

// A ball before the wall: its shadow is where the line to the sun passes the middle at less than r, drawn
// from a mesh of 32 x 16 corners (r cos(pi / 16) at least) into a map with texels of 10 / 1024. It is not
// baked.
static void test_ball(void **unused) {
    (void)unused;
    Scene scene = lit_wall(2, LIGHT_DIRECTIONAL, vec3_make(3, 2, 5), 1);
    const vec3s center = vec3_make(-0.2f, 0.3f, 1);
    scene.lights[0].target = vec3_make(0, 0, 0);
    const double r = 0.4, texel = 10.0 / 1024;
    Luxels without = luxels_draw(&scene, "light map", 4, NULL, 0);
    closed_add(&scene, SHAPE_SPHERE, center, vec3_make((float)r, (float)r, (float)r), 0);
    Luxels with = luxels_draw(&scene, "light map", 4, NULL, 0);
    assert_memory_equal(with.image.rgba, without.image.rgba,
                        4 * (size_t)with.image.width * (size_t)with.image.height);
    luxels_destroy(&with);
    luxels_destroy(&without);
    const WitnessKnob knobs[] = {{"map size", 1024}};
    Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 1);
    vec3s to_sun = glms_vec3_normalize(glms_vec3_sub(scene.lights[0].position, scene.lights[0].target));
    double unit = closed_unit(&scene, SIZE), dark = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        vec3s place = vec3_make((float)((i % SIZE + 0.5 - SIZE / 2) * unit),
                                (float)((SIZE / 2 - 0.5 - floor((double)i / SIZE)) * unit), 0);
        vec3s from = glms_vec3_sub(center, place), eye = glms_vec3_sub(scene.camera.eye, place);
        double off = glms_vec3_norm(glms_vec3_cross(from, to_sun));
        double aside = glms_vec3_norm(glms_vec3_cross(from, glms_vec3_normalize(eye)));
        if (fmax(fabsf(place.x), fabsf(place.y)) > 2 - unit || aside < r + unit ||
            (off > r * cos(GLM_PI / 16) - 2 * texel && off < r + 2 * texel))
            continue;
        assert_int_equal(image.rgba[4 * i], off < r ? 0 : 255);
        dark += off < r;
    }
    print_message("%.0f pixels in the ball's shadow\n", dark);
    assert_true(dark > 100);
    image_destroy(&image);
}

// A mirrored object's charts would look inwards.
static void test_mirrored(void **unused) {
    (void)unused;
    for (int i = 0; i < 2; i++) {
        Scene scene = lit_wall(1, LIGHT_POINT, lamp, 1);
        Atlas atlas = {0};
        closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 1), vec3_make(i ? 0 : -0.3f, 0.3f, 0.3f), 20);
        assert_false(atlas_layout(&atlas, &scene, 4, 1));
        assert_non_null(strstr(check_message(), "object 1 is mirrored or flat"));
        atlas_destroy(&atlas);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_irradiance), cmocka_unit_test(test_sun),
                                       cmocka_unit_test(test_plates),     cmocka_unit_test(test_penumbra),
                                       cmocka_unit_test(test_picture),    cmocka_unit_test(test_ball),
                                       cmocka_unit_test(test_mirrored)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
