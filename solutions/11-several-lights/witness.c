// Lab 11's pictures against segments from each visible point to each light, and against sums.
#include "scene/count.h"
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { SIZE = 200, MAP_SIZE = 256, MOST_PLATES = 6 };
static const double field = 40, distance = 10; // of the camera: degrees, world units

typedef struct Setup {
    WitnessPlate plates[MOST_PLATES];
    int plate_count;
    Light lights[SCENE_MAX_LIGHTS];
    int light_count;
} Setup;

static void add_light(Setup *setup, LightKind kind, vec3s position, vec3s target) {
    Scene scene = {0};
    closed_light(&scene, kind, position, target, glm_rad(100), 5, kind == LIGHT_POINT ? 0.3f : 1, 20);
    setup->lights[setup->light_count++] = scene.lights[0];
}

static Scene make_scene(const Setup *setup) {
    Scene scene = closed_wall(6, (float)distance, glm_rad((float)field));
    for (int i = 0; i < setup->plate_count; i++) {
        float half = setup->plates[i].half;
        closed_add(&scene, SHAPE_BOX, setup->plates[i].center, vec3_make(half, half, 1e-4f), 0);
    }
    memcpy(scene.lights, setup->lights, sizeof scene.lights);
    scene.light_count = setup->light_count;
    return scene;
}

// Does a plate, made larger by `margin`, cut the segment from the point to the end?
static bool is_cut(const Setup *setup, vec3s point, vec3s end, float margin) {
    return witness_cuts(setup->plates, setup->plate_count, point, end, margin);
}

static vec3s end_of(const Light *light, vec3s point) {
    if (light->kind != LIGHT_DIRECTIONAL)
        return light->position;
    return glms_vec3_add(point, glms_vec3_scale(glms_vec3_sub(light->position, light->target), 100));
}

// The share of the lights that reach the point; -1 where a segment passes within `margin` of a plate's edge.
static double light_at(const Setup *setup, vec3s point, float margin) {
    double lit = 0;
    for (int i = 0; i < setup->light_count; i++) {
        vec3s end = end_of(&setup->lights[i], point);
        bool cut = is_cut(setup, point, end, margin);
        if (cut != is_cut(setup, point, end, -margin))
            return -1;
        lit += !cut;
    }
    return lit / setup->light_count;
}

// Where the ray through a pixel's middle meets the wall.
static vec3s seen_at(int column, int row) {
    double half = distance * tan(closed_radians(field) / 2);
    return vec3_make((float)((2 * (column + 0.5) / SIZE - 1) * half),
                     (float)((1 - 2 * (row + 0.5) / SIZE) * half), 0);
}

// In each pixel where no plate hides the wall and no edge is near. A texel is at most 2 tan(50 degrees) / 256
// = 0.0094 wide at the distance 1 (of a sun 10 / 256 = 0.039), and the plates are at most 5 away; a lookup
// asks texels up to one away, and where light falls at an angle they are stretched: 0.15 is enough.
static void compare(const Setup *setup, const char *what) {
    const Scene scene = make_scene(setup);
    const WitnessKnob knobs[] = {{"map size", MAP_SIZE}};
    Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 1);
    int judged = 0, dark = 0, wrong = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        vec3s point = seen_at(i % SIZE, i / SIZE);
        double expected = light_at(setup, point, 0.15f);
        if (expected < 0 || is_cut(setup, point, scene.camera.eye, 0.1f))
            continue;
        judged++;
        dark += expected < 1;
        wrong += fabs(image.rgba[4 * (size_t)i] / 255.0 - expected) > 1 / 255.0;
    }
    print_message("%s: %d pixels judged, %d in shadow, %d wrong\n", what, judged, dark, wrong);
    assert_true(judged > SIZE * SIZE / 2 && dark > 100 && wrong == 0);
    image_destroy(&image);
}

static Setup plates_before_wall(void) {
    return (Setup){.plates = {{{{-1.2f, 0.2f, 1.5f}}, 0.6f}, {{{1.4f, -0.8f, 2}}, 0.5f}}, .plate_count = 2};
}

static void test_several(void **unused) {
    (void)unused;
    Setup setup = plates_before_wall();
    add_light(&setup, LIGHT_SPOT, vec3_make(-1, 0.3f, 5), vec3_make(0, 0, 0));
    compare(&setup, "one light");
    add_light(&setup, LIGHT_DIRECTIONAL, vec3_make(2, 2, 6), vec3_make(0, 0.5f, 0));
    compare(&setup, "two lights");
    add_light(&setup, LIGHT_POINT, vec3_make(0.3f, 0.2f, 3.5f), vec3_make(0, 9, 3.5f));
    compare(&setup, "and a lamp");
    add_light(&setup, LIGHT_SPOT, vec3_make(0.5f, -1.5f, 6), vec3_make(0.2f, 0, 0));
    compare(&setup, "four lights");
}

// The shadow of a plate that two or three faces of the cube see, wherever the lamp is.
static void test_cube(void **unused) {
    (void)unused;
    for (int i = 0; i < 8; i++) {
        float x = i % 2 ? 0.4f : -0.4f, y = i / 2 % 2 ? 0.3f : -0.3f, z = i < 4 ? 1.6f : 1.2f;
        Setup setup = {
            .plates = {{{{x + (x < 0 ? 0.5f : -0.5f), y + (y < 0 ? 0.5f : -0.5f), z - 0.5f}}, 0.25f},
                       {{{x, y, z + 1}}, 0.4f}},
            .plate_count = 2};
        add_light(&setup, LIGHT_POINT, vec3_make(x, y, z), vec3_make(x, y + 1, z));
        compare(&setup, "a plate before a corner of the cube");
    }
}

// Window depth in the cube: of what lies m away along a face's axis, (f + n) / (f - n) - 2 f n / ((f - n) m)
// in [-1, 1]. The face -z looks straight at the wall, +z away from it.
static void test_depth(void **unused) {
    (void)unused;
    for (int m = 1; m <= 8; m++) {
        Setup setup = {0};
        add_light(&setup, LIGHT_POINT, vec3_make(0, 0, (float)m), vec3_make(0, 0, 9));
        const Scene scene = make_scene(&setup);
        const WitnessKnob knobs[] = {{"map size", 32}};
        Image image = witness_draw(LAB_ID, &scene, "cube", 96, 64, knobs, 1);
        assert_true(scene.lights[0].far_plane == 20);
        double depth =
            prediction_answer(LAB_ID, 0, (const double[4]){0, 0, m, (double)scene.lights[0].near_plane});
        size_t at = image_at(&image, 80, 16), away = image_at(&image, 48, 16);
        print_message("wall at %d: depth %.4f, expected %.4f\n", m, image.rgba[at] / 255.0, depth);
        assert_true(fabs(image.rgba[at] / 255.0 - depth) <= 0.51 / 255);
        assert_int_equal(image.rgba[away], 255);
        image_destroy(&image);
    }
}

// Two scenes' pictures differ by a light: what the lights add alone is what they add together. Each picture
// is rounded by half a step.
static void test_sum(void **unused) {
    (void)unused;
    Setup setup = plates_before_wall();
    add_light(&setup, LIGHT_SPOT, vec3_make(-1, 0.3f, 5), vec3_make(0, 0, 0));
    add_light(&setup, LIGHT_POINT, vec3_make(1, 1, 3), vec3_make(0, 0, 0));
    add_light(&setup, LIGHT_DIRECTIONAL, vec3_make(2, 2, 6), vec3_make(0, 0.5f, 0));
    Scene scene = make_scene(&setup);
    scene.ambient = vec3_make(0.1f, 0.12f, 0.15f);
    for (int i = 0; i < setup.light_count; i++)
        scene.lights[i].color = vec3_make(0.05f + 0.1f * (float)i, 0.2f, 0.25f - 0.1f * (float)i);
    Image all = witness_draw(LAB_ID, &scene, "picture", SIZE, SIZE, NULL, 0), alone[SCENE_MAX_LIGHTS];
    for (int i = 0; i <= setup.light_count; i++) {
        Scene one = scene;
        one.light_count = i < setup.light_count; // the last picture has none
        one.lights[0] = scene.lights[i < setup.light_count ? i : 0];
        alone[i] = witness_draw(LAB_ID, &one, "picture", SIZE, SIZE, NULL, 0);
    }
    int most = 0;
    for (size_t k = 0; k < image_bytes(&all); k++) {
        if (k % 4 == 3)
            continue;
        int sum = alone[setup.light_count].rgba[k];
        for (int i = 0; i < setup.light_count; i++)
            sum += alone[i].rgba[k] - alone[setup.light_count].rgba[k];
        most = abs(sum - all.rgba[k]) > most ? abs(sum - all.rgba[k]) : most;
    }
    print_message("three lights: at most %d steps off\n", most);
    assert_true(most <= 3); // 1 + 3 + 2 half steps
    for (int i = 0; i <= setup.light_count; i++)
        image_destroy(&alone[i]);
    image_destroy(&all);
}

// A lamp of side s = 2 e at the height H and a plate's edge at the height h: the penumbra is s h / (H - h)
// wide, and light falls in it linearly. n small lamps make steps at most 1 / (2 n) away from that; each edge
// is moved by a texel of the map at most (as wide as it is on the wall), and 8 bits round.
static void test_penumbra(void **unused) {
    (void)unused;
    for (int n = 2; n <= 8; n *= 2) {
        Setup setup = {.plates = {{{{-1.2f, 0.2f, 2}}, 0.5f}}, .plate_count = 1};
        const WitnessPlate *plate = &setup.plates[0];
        add_light(&setup, LIGHT_SPOT, vec3_make(-3, 0.3f, 5), vec3_make(-3, 0.3f, 0));
        setup.lights[0].extent = 0.4f;
        const Scene scene = make_scene(&setup);
        const WitnessKnob knobs[] = {{"lamps", (float)n}, {"jitter", 0}, {"map size", 1024}};
        Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 3);
        double H = 5, h = 2, width = prediction_answer(LAB_ID, 1, (const double[4]){0.4, H, h}), worst = 0;
        double edge = (((double)plate->center.x + 0.5) * H + 3 * h) / (H - h);
        double texel = 2 * tan(closed_radians(50)) * H / 1024;
        int row = SIZE / 2, inside = 0;
        for (int x = 0; x < SIZE; x++) {
            double t = ((double)seen_at(x, row).x - edge) / width + 0.5;
            if (t < -1 || t > 2)
                continue;
            worst = fmax(worst, fabs(image.rgba[4 * (row * SIZE + x)] / 255.0 - fmin(fmax(t, 0), 1)));
            inside += t > 0 && t < 1;
        }
        print_message("%d lamps a side: %d pixels of penumbra, at most %.4f off\n", n, inside, worst);
        assert_true(inside > 10 && worst <= 1 / (2.0 * n) + texel / width + 0.6 / 255);
        image_destroy(&image);
    }
}

// Four wide lights cannot have 8 x 8 lamps each in 64 layers: they get as many as fit, 4 x 4.
static void test_too_many(void **unused) {
    (void)unused;
    Setup setup = plates_before_wall();
    for (int i = 0; i < SCENE_MAX_LIGHTS; i++) {
        add_light(&setup, LIGHT_SPOT, vec3_make(2 * (float)i - 3, 0.3f, 5), vec3_make(0, 0, 0));
        setup.lights[i].extent = 0.3f;
    }
    const Scene scene = make_scene(&setup);
    Image pictures[5];
    for (int n = 4; n <= 8; n++) {
        const WitnessKnob knobs[] = {{"lamps", (float)n}, {"map size", 64}};
        pictures[n - 4] = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 2);
        assert_memory_equal(pictures[0].rgba, pictures[n - 4].rgba, image_bytes(&pictures[0]));
    }
    for (int n = 4; n <= 8; n++)
        image_destroy(&pictures[n - 4]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_several),  cmocka_unit_test(test_cube),
                                       cmocka_unit_test(test_depth),    cmocka_unit_test(test_sum),
                                       cmocka_unit_test(test_penumbra), cmocka_unit_test(test_too_many)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
