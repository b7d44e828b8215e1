// Lab 13's dust against integrals along the rays, whose dark segments are cut out of thin plates by hand.
#include "scene/count.h"
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 120, MOST_PLATES = 4, MARCH = 1, FACES = 2 };
static const double field = 40, distance = 10; // of the camera: degrees, world units

// A square plate in the plane x = center.x, so that the sun along -x throws its shadow straight away from it.
typedef struct Plate {
    vec3s center;
    float half;
} Plate;

typedef struct Setup {
    Plate plates[MOST_PLATES];
    int plate_count;
    Medium medium;
    LightKind kind;
    vec3s light, target;
} Setup;

// A wall in the plane z = 0, seen from (0, 0, 10).
static Scene make_scene(const Setup *setup) {
    Scene scene = closed_wall(20, (float)distance, glm_rad((float)field));
    for (int i = 0; i < setup->plate_count; i++) {
        float half = setup->plates[i].half;
        closed_add(&scene, SHAPE_BOX, setup->plates[i].center, vec3_make(1e-5f, half, half), 0);
    }
    closed_light(&scene, setup->kind, setup->light, setup->target, 1, 9, 0.5f, 30);
    scene.medium = setup->medium;
    return scene;
}

// The sum of e^(-extinction t) from a to b, by definition: Simpson's rule, whose error is below 1e-9 here.
static double sum_between(const Medium *medium, double a, double b) {
    const int parts = 64;
    double sum = 0, h = (b - a) / parts;
    for (int i = 0; i <= parts; i++)
        sum += exp(-(double)medium->extinction * (a + i * h)) * (i == 0 || i == parts ? 1 : i % 2 ? 4 : 2);
    sum *= medium->scattering * h / 3;
    const double given[4] = {medium->scattering, medium->extinction, a, b - a}; // what a student predicts
    if (given[1] > 1e-3) {
        assert_true(fabs(sum - prediction_answer(LAB_ID, 1, given)) < 1e-7);
        assert_true(a != 0 || fabs(sum - prediction_answer(LAB_ID, 0,
                                                           (const double[4]){given[0], given[1], b})) < 1e-7);
    }
    return sum;
}

// The way to the wall, and the ray's direction of length 1, through the middle of a pixel.
static double way_of(int column, int row, double direction[3]) {
    double half = tan(closed_radians(field) / 2), x = (2 * (column + 0.5) / SIZE - 1) * half,
           y = (1 - 2 * (row + 0.5) / SIZE) * half, length = sqrt(x * x + y * y + 1);
    direction[0] = x / length, direction[1] = y / length, direction[2] = -1 / length;
    return distance * length;
}

// Does light reach the point at `t` of the ray? The segment to the light is cut with each plate.
static bool is_lit(const Setup *setup, const double direction[3], double t) {
    vec3s point =
        vec3_make((float)(t * direction[0]), (float)(t * direction[1]), (float)(distance + t * direction[2]));
    bool sun = setup->kind == LIGHT_DIRECTIONAL;
    vec3s axis = glms_vec3_sub(setup->target, setup->light);
    vec3s to_light = sun ? glms_vec3_scale(axis, -100) : glms_vec3_sub(setup->light, point);
    for (int i = 0; i < setup->plate_count; i++) {
        const Plate *plate = &setup->plates[i];
        float s = (plate->center.x - point.x) / to_light.x;
        vec3s at = glms_vec3_add(point, glms_vec3_scale(to_light, s));
        if (s > 0 && s < 1 && fabsf(at.y - plate->center.y) < plate->half &&
            fabsf(at.z - plate->center.z) < plate->half)
            return false;
    }
    return sun || glms_vec3_dot(glms_vec3_sub(point, setup->light), axis) > 0;
}

// Where between a (lit as `lit`) and b the light changes.
static double border(const Setup *setup, const double direction[3], double a, double b, bool lit) {
    for (int i = 0; i < 40; i++) {
        double middle = (a + b) / 2;
        if (is_lit(setup, direction, middle) == lit)
            a = middle;
        else
            b = middle;
    }
    return a;
}

// What the dust of a pixel's ray sends, and how many borders of shadow the ray meets. Borders are looked for
// on a grid of 2000; none of the plates below throws a shadow that is thinner.
static double expected_dust(const Setup *setup, int column, int row, int *borders) {
    enum { GRID = 2000 };
    double direction[3], way = way_of(column, row, direction), from = 0, sum = 0;
    bool lit = is_lit(setup, direction, 1e-6);
    *borders = 0;
    for (int i = 1; i <= GRID; i++) {
        double t = way * i / GRID;
        if (is_lit(setup, direction, t) == lit)
            continue;
        double change = border(setup, direction, t - way / GRID, t, lit);
        sum += lit ? sum_between(&setup->medium, from, change) : 0;
        from = change, lit = !lit, ++*borders;
    }
    return sum + (lit ? sum_between(&setup->medium, from, way) : 0);
}

static Image draw(const Setup *setup, int how, float steps) {
    const Scene scene = make_scene(setup);
    const WitnessKnob knobs[] = {{"dust", (float)how}, {"steps", steps}, {"jitter", 0}, {"map size", 2048}};
    return witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, COUNT(knobs));
}

static double dust_at(const Image *image, int column, int row) {
    return image->rgba[image_at(image, column, row)] / 255.0;
}

// Is the pixel's ray past all plates' own outlines? A plate seen from its edge is thinner than a pixel, and
// OpenGL puts vertices on a grid of 1/256 pixel.
static bool is_clear(const Setup *setup, int column, int row) {
    double direction[3], way = way_of(column, row, direction);
    for (int i = 0; i < setup->plate_count; i++) {
        double t = setup->plates[i].center.x / direction[0];
        if (t > 0 && t < way * 1.001 &&
            fabs(t * direction[1] - (double)setup->plates[i].center.y) <
                (double)setup->plates[i].half + 0.1 &&
            fabs(distance + t * direction[2] - (double)setup->plates[i].center.z) <
                (double)setup->plates[i].half + 0.1)
            return false;
    }
    return true;
}

// By faces each pixel is exact: half a step of the picture's 255, and the sides of the volumes, moved by
// 1/256 pixel, where the ray nearly lies in one: few pixels.
static void compare_faces(const Setup *setup, const char *what) {
    Image image = draw(setup, FACES, 1);
    int shadowed = 0, wrong = 0, counted = 0, borders;
    for (int i = 0; i < SIZE * SIZE; i++) {
        if (!is_clear(setup, i % SIZE, i / SIZE))
            continue;
        double right = expected_dust(setup, i % SIZE, i / SIZE, &borders);
        counted++;
        shadowed += borders > 0;
        wrong += fabs(dust_at(&image, i % SIZE, i / SIZE) - right) > 0.6 / 255;
    }
    print_message("%s: %d of %d pixels meet a shadow, %d wrong\n", what, shadowed, counted, wrong);
    assert_true(counted > SIZE * SIZE / 2 && wrong <= 4 + shadowed / 100);
    image_destroy(&image);
}

static Setup sun_and_plate(void) {
    return (Setup){.plates = {{{{2, 0.4f, 4}}, 1}},
                   .plate_count = 1,
                   .medium = {0.06f, 0.08f},
                   .kind = LIGHT_DIRECTIONAL,
                   .light = vec3_make(8, 2, 5),
                   .target = vec3_make(0, 0, 4)};
}

static void test_media(void **unused) {
    (void)unused;
    const Medium media[] = {{0.06f, 0.08f}, {0.08f, 0},     {0.07f, 1e-5f},
                            {0.3f, 0.4f},   {0.05f, 0.02f}, {0, 0.1f}};
    for (size_t i = 0; i < COUNT(media); i++) {
        Setup setup = sun_and_plate();
        setup.medium = media[i];
        compare_faces(&setup, "a sun and a plate");
    }
}

static void test_lamps(void **unused) {
    (void)unused;
    const vec3s lamps[] = {{{5, 1, 4}}, {{4, -1, 6}}, {{3, 0.4f, 2}}, {{6, 3, 9}}};
    for (size_t i = 0; i < COUNT(lamps); i++) {
        Setup setup = sun_and_plate();
        setup.kind = LIGHT_SPOT;
        setup.light = lamps[i];
        setup.target = vec3_make(0, 0, 4);
        compare_faces(&setup, "a spot light, dark behind it");
    }
}

// Plates behind each other, overlapping in part, and one apart.
static void test_overlap(void **unused) {
    (void)unused;
    Setup setup = sun_and_plate();
    setup.plate_count = 4;
    setup.plates[1] = (Plate){{{1, 0.1f, 4.3f}}, 0.8f};
    setup.plates[2] = (Plate){{{0.2f, 0.9f, 3.5f}}, 0.6f};
    setup.plates[3] = (Plate){{{1.5f, -0.6f, 7.5f}}, 0.7f};
    compare_faces(&setup, "four plates");
    setup.kind = LIGHT_SPOT;
    setup.light = vec3_make(6, 1, 5);
    compare_faces(&setup, "four plates and a spot light");
}

// The eye in one shadow, and in two.
static void test_eye_inside(void **unused) {
    (void)unused;
    for (int count = 1; count <= 2; count++) {
        Setup setup = sun_and_plate();
        setup.plate_count = count;
        setup.plates[0] = (Plate){{{3, 0.2f, 10.3f}}, 1.1f};
        setup.plates[1] = (Plate){{{2, -0.1f, 9.9f}}, 0.9f};
        setup.light = vec3_make(9, 0.5f, 10);
        setup.target = vec3_make(0, 0, 9.5f);
        compare_faces(&setup, "the eye in a shadow");
        setup.kind = LIGHT_SPOT;
        compare_faces(&setup, "the eye in a shadow of a spot light");
    }
}

// Midpoints: within one step the sum of a smooth part errs by less than 1/24 of s a^2 dt^3, and a border of
// the shadow is missed by at most half a step and a texel on the ray (a texel is 18/2048 units; the ray
// crosses it at 1/4 of that at the least, or is not asked).
static void test_march(void **unused) {
    (void)unused;
    for (int steps = 4; steps <= 64; steps *= 2) {
        const Setup setup = sun_and_plate();
        Image image = draw(&setup, MARCH, (float)steps);
        int wrong = 0, shadowed = 0, borders;
        double worst = 0, s = setup.medium.scattering, a = setup.medium.extinction;
        for (int i = 0; i < SIZE * SIZE; i++) {
            double direction[3], way = way_of(i % SIZE, i / SIZE, direction), dt = way / steps;
            if (!is_clear(&setup, i % SIZE, i / SIZE))
                continue;
            double right = expected_dust(&setup, i % SIZE, i / SIZE, &borders);
            double missed = prediction_answer(LAB_ID, 2, (const double[4]){steps, way, s});
            double allowed =
                s * a * a * dt * dt * way / 24 + borders * (missed + s * 4 * 18 / 2048.0) + 0.6 / 255;
            double error = fabs(dust_at(&image, i % SIZE, i / SIZE) - right);
            worst = fmax(worst, error);
            shadowed += borders > 0;
            wrong += error > allowed;
        }
        print_message("%d steps: %d pixels meet a shadow, at most %.4f off, %d too far\n", steps, shadowed,
                      worst, wrong);
        assert_true(shadowed > 100 && wrong <= 4 + shadowed / 100);
        image_destroy(&image);
    }
}

// With jitter the mean over many pixels is right: each pixel's error is within a step for each border, so its
// spread is at most s dt / sqrt(3), and four standard errors of the mean remain.
static void test_jitter(void **unused) {
    (void)unused;
    const int steps = 5;
    const Setup setup = sun_and_plate();
    const Scene scene = make_scene(&setup);
    const WitnessKnob knobs[] = {{"dust", MARCH}, {"steps", (float)steps}, {"jitter", 1}, {"map size", 2048}};
    Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, knobs, COUNT(knobs));
    double sum = 0, spread = 0;
    int count = 0, borders;
    for (int i = 0; i < SIZE * SIZE; i++) {
        double direction[3], dt = way_of(i % SIZE, i / SIZE, direction) / steps;
        if (!is_clear(&setup, i % SIZE, i / SIZE))
            continue;
        double error =
            dust_at(&image, i % SIZE, i / SIZE) - expected_dust(&setup, i % SIZE, i / SIZE, &borders);
        double each = (double)setup.medium.scattering * dt * ((double)borders + 0.5) / sqrt(3);
        sum += error;
        spread += each * each;
        count++;
    }
    print_message("jitter: mean error %.5f over %d pixels, four standard errors %.5f\n", sum / count, count,
                  4 * sqrt(spread) / count);
    assert_true(fabs(sum / count) < 4 * sqrt(spread) / count + 0.1 / 255);
    image_destroy(&image);
}

static void test_refusals(void **unused) {
    (void)unused;
    Setup setup = sun_and_plate();
    Scene scene = make_scene(&setup);
    scene.objects[1].world_from_object.raw[0][0] *= -1;
    witness_refuses(LAB_ID, &scene, "object 1 of the scene is mirrored or flat");
    setup.kind = LIGHT_POINT;
    scene = make_scene(&setup);
    witness_refuses(LAB_ID, &scene, "point light");
    setup = sun_and_plate();
    scene = make_scene(&setup);
    for (int i = 1; i < 9; i++)
        closed_add(&scene, SHAPE_BOX, vec3_make(0, (float)i, 0), vec3_make(0.1f, 0.1f, 0.1f), 0);
    witness_refuses(LAB_ID, &scene, "8 boxes and spheres at most");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_media),    cmocka_unit_test(test_lamps),
                                       cmocka_unit_test(test_overlap),  cmocka_unit_test(test_eye_inside),
                                       cmocka_unit_test(test_refusals), cmocka_unit_test(test_march),
                                       cmocka_unit_test(test_jitter)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
