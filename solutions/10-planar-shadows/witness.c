// Lab 10's shadows against segments from each visible point to the light, cut with thin plates by hand.
#include "scene/count.h"
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 240, MOST_PLATES = 4 };
static const double field = 40, distance = 10; // of the camera: degrees, world units

// A wall through the origin, turned about +y, with plates before it.
typedef struct Setup {
    WitnessPlate plates[MOST_PLATES];
    int plate_count;
    double turn; // degrees
    LightKind kind;
    vec3s light, target;
    float extent, opacity;
    int lamps;
} Setup;

static Scene make_scene(const Setup *setup) {
    Scene scene = closed_wall(6, (float)distance, glm_rad((float)field));
    Object *wall = &scene.objects[0];
    mat4s turned = glms_rotate_make(glm_rad((float)setup->turn), vec3_make(0, 1, 0));
    wall->world_from_object = glms_mat4_mul(turned, wall->world_from_object);
    for (int i = 0; i < setup->plate_count; i++) {
        float half = setup->plates[i].half;
        closed_add(&scene, SHAPE_BOX, setup->plates[i].center, vec3_make(half, half, 1e-5f), 0);
    }
    closed_light(&scene, setup->kind, setup->light, setup->target, 1, 5, 1, 20);
    scene.lights[0].extent = setup->extent;
    return scene;
}

// Does a plate, made larger by `margin`, cut the segment from the point to the end?
static bool is_cut(const Setup *setup, vec3s point, vec3s end, float margin) {
    return witness_cuts(setup->plates, setup->plate_count, point, end, margin);
}

// Light that reaches the point: of n x n regular lamps on the square, or of a sun.
static double light_at(const Setup *setup, vec3s point) {
    if (setup->kind == LIGHT_DIRECTIONAL) {
        vec3s to_light = glms_vec3_scale(glms_vec3_sub(setup->light, setup->target), 100);
        return 1 - setup->opacity * is_cut(setup, point, glms_vec3_add(point, to_light), 0);
    }
    double taken = 0;
    int n = setup->lamps;
    for (int k = 0; k < n * n; k++) {
        vec3s lamp = setup->light;
        lamp.x += setup->extent * (2 * ((float)(k % n) + 0.5f) / (float)n - 1);
        lamp.y += setup->extent * (2 * (floorf((float)k / (float)n) + 0.5f) / (float)n - 1);
        taken += is_cut(setup, point, lamp, 0);
    }
    return 1 - setup->opacity * taken / (n * n);
}

// Where the ray through a pixel's middle meets the wall.
static vec3s seen_at(const Setup *setup, int column, int row) {
    double half = tan(closed_radians(field) / 2), x = (2 * (column + 0.5) / SIZE - 1) * half,
           y = (1 - 2 * (row + 0.5) / SIZE) * half, turn = closed_radians(setup->turn);
    double depth = distance * cos(turn) / (cos(turn) - sin(turn) * x);
    return vec3_make((float)(x * depth), (float)(y * depth), (float)(distance - depth));
}

// The picture must be that of the segments in each pixel where no plate hides the wall. OpenGL puts vertices
// on a grid of 1/256 pixel, and the plates are 0.00002 thick, less than that: an edge may sweep over 1/64 of
// the pixels along it.
static void compare(const Setup *setup, const char *what) {
    const Scene scene = make_scene(setup);
    const WitnessKnob knobs[] = {{"opacity", setup->opacity}, {"lamps", (float)setup->lamps}, {"jitter", 0}};
    Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 3);
    int edges = 0, wrong = 0, dark = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        vec3s point = seen_at(setup, i % SIZE, i / SIZE);
        if (is_cut(setup, point, scene.camera.eye, 0.1f))
            continue;
        double expected = light_at(setup, point), measured = image.rgba[4 * (size_t)i] / 255.0;
        double before = i % SIZE ? light_at(setup, seen_at(setup, i % SIZE - 1, i / SIZE)) : expected;
        double above = i >= SIZE ? light_at(setup, seen_at(setup, i % SIZE, i / SIZE - 1)) : expected;
        edges += before != expected || above != expected;
        dark += expected < 1;
        wrong += fabs(measured - expected) > 1 / 255.0;
    }
    print_message("%s: %d pixels in shadow, %d at edges, %d wrong\n", what, dark, edges, wrong);
    assert_true(wrong <= 4 + edges / 64);
    image_destroy(&image);
}

static Setup lamp_and_plate(void) {
    return (Setup){.plates = {{{{-1.2f, 0.2f, 2}}, 0.5f}},
                   .plate_count = 1,
                   .kind = LIGHT_POINT,
                   .light = vec3_make(-3, 0.3f, 5),
                   .target = vec3_make(-3, 0.3f, 0),
                   .opacity = 1,
                   .lamps = 1};
}

static void test_planes(void **unused) {
    (void)unused;
    for (int turn = -30; turn <= 30; turn += 15) {
        Setup setup = lamp_and_plate();
        setup.turn = turn;
        compare(&setup, "a lamp");
        setup.kind = LIGHT_DIRECTIONAL;
        setup.target = vec3_make(0.5f, 0.2f, 0);
        compare(&setup, "a sun");
    }
}

// Higher than the lamp, in the lamp's own height, behind the wall: none of them is between.
static void test_between(void **unused) {
    (void)unused;
    const float heights[] = {5.6f, 7, -0.5f, -3};
    for (size_t i = 0; i < COUNT(heights); i++) {
        Setup setup = lamp_and_plate();
        setup.plate_count = 2;
        setup.plates[1] = (WitnessPlate){{{-2.2f, -0.4f, heights[i]}}, 0.4f};
        compare(&setup, "a plate past the lamp, or behind the wall");
    }
}

// Plates in one shadow take the light once.
static void test_once(void **unused) {
    (void)unused;
    Setup setup = lamp_and_plate();
    setup.opacity = 0.4f;
    setup.plate_count = 3;
    setup.plates[1] = (WitnessPlate){{{-1.5f, 0.3f, 2.6f}}, 0.4f};
    setup.plates[2] = (WitnessPlate){{{-1.9f, 0.1f, 3.2f}}, 0.3f};
    compare(&setup, "three plates of glass");
}

static void test_lamps(void **unused) {
    (void)unused;
    const int some[] = {1, 2, 3, 5, 10, 16};
    for (size_t i = 0; i < COUNT(some); i++) {
        Setup setup = lamp_and_plate();
        setup.extent = 0.6f;
        setup.lamps = some[i];
        compare(&setup, "a wide lamp");
    }
}

// A lamp of side s = 2 e at the height H and a plate's edge at the height h: the penumbra is s h / (H - h)
// wide, and light falls in it linearly. n regular lamps make n steps, at most 1 / (2 n) away from that (and a
// half step of the picture's 255).
static void test_penumbra(void **unused) {
    (void)unused;
    for (int n = 2; n <= 16; n *= 2) {
        Setup setup = lamp_and_plate();
        setup.extent = 0.4f;
        setup.lamps = n;
        const WitnessPlate *plate = &setup.plates[0];
        Scene scene = make_scene(&setup);
        const WitnessKnob knobs[] = {{"lamps", (float)n}, {"jitter", 0}};
        Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, 2);
        double H = setup.light.z, h = plate->center.z, worst = 0;
        double width = prediction_answer(LAB_ID, 0, (const double[4]){2 * setup.extent, H, h});
        double edge = ((plate->center.x + plate->half) * H - setup.light.x * h) / (H - h);
        int row = SIZE / 2, inside = 0;
        for (int x = 0; x < SIZE; x++) {
            double t = (seen_at(&setup, x, row).x - edge) / width + 0.5;
            if (t < -1 || t > 2)
                continue;
            worst = fmax(worst, fabs(image.rgba[4 * (row * SIZE + x)] / 255.0 - fmin(fmax(t, 0), 1)));
            inside += t > 0 && t < 1;
        }
        print_message("%d lamps a side: %d pixels of penumbra, at most %.4f off\n", n, inside, worst);
        assert_true(inside > 10 && worst <= prediction_answer(LAB_ID, 2, (const double[4]){n}) + 0.6 / 255);
        image_destroy(&image);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_planes), cmocka_unit_test(test_between),
                                       cmocka_unit_test(test_once), cmocka_unit_test(test_lamps),
                                       cmocka_unit_test(test_penumbra)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
