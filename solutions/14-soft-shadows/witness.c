// Lab 14's penumbrae against closed forms (they stand at each test). A lamp straight before a wall, plates
// parallel to it.
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 320, MAP = 2048 };
static const double extent = 0.5; // half the lamp's side

static Scene lamp_and_wall(void) {
    Scene scene = closed_wall_and_lamp(SIZE, SIZE);
    scene.lights[0].extent = (float)extent;
    return scene;
}

static Image draw(const Scene *scene, const char *view, int filter_taps) {
    const WitnessKnob knobs[] = {{"map size", MAP}, {"filter taps", (float)filter_taps}, {"search taps", 16}};
    return witness_draw(LAB_ID, scene, view, SIZE, SIZE, knobs, 3);
}

static double width_of(double h) {
    return 2 * extent * h / (CLOSED_LAMP_AT - h);
}

// Light falls as 1/2 + x / w, with w = S h / (H - h). n taps make steps at most 1 / (2 n) from that, each
// edge is moved by a texel at most, and 8 bits round.
static void test_ramp(void **unused) {
    (void)unused;
    for (int i = 1; i <= 5; i++) {
        double h = 0.6 * i, worst = 0, texel = closed_lamp_texel(MAP);
        const int taps = 16;
        Scene scene = lamp_and_wall();
        closed_plate(&scene, h, 0);
        Image image = draw(&scene, "visibility", taps);
        double unit = closed_unit(&scene, SIZE);
        int inside = 0;
        for (int column = 0; column < SIZE; column++) {
            double t = (column + 0.5 - SIZE / 2.0) * unit / width_of(h) + 0.5;
            if (t < 0 || t > 2)
                continue;
            worst = fmax(worst, fabs(image.rgba[image_at(&image, column, SIZE / 2)] / 255.0 - fmin(t, 1)));
            inside += t < 1;
        }
        print_message("h = %.1f: %d pixels of penumbra, at most %.4f off\n", h, inside, worst);
        assert_true(inside > 5 && worst <= 1.0 / (2 * taps) + texel / width_of(h) + 0.6 / 255);
        image_destroy(&image);
    }
}

// What a stage shows at a place of the wall, against what is expected in [0, 1].
static void check_stage(const Scene *scene, const char *stage, double x, double expected) {
    Image image = draw(scene, stage, 4);
    int column = SIZE / 2 + (int)floor(x / closed_unit(scene, SIZE));
    int shown = image.rgba[image_at(&image, column, SIZE / 2)];
    print_message("%s: %d, expected %.1f\n", stage, shown, 255 * expected);
    assert_true(fabs(shown - 255 * fmin(expected, 1)) <= 0.6);
    image_destroy(&image);
}

// A blocker as far before the receiver as the second prediction says has a kernel of one texel by the first.
static void test_kernel_of_a_texel(void **unused) {
    (void)unused;
    for (int texels = 128; texels <= 2048; texels *= 2) {
        const double side = 0.8, receiver = 9.5, angle = 52,
                     h = prediction_answer(LAB_ID, 1, (const double[4]){side, receiver, angle, texels}),
                     kernel =
                         prediction_answer(LAB_ID, 0, (const double[4]){side, receiver, receiver - h, angle});
        assert_true(h > 0 && fabs(kernel * texels - 1) < 1e-9);
    }
}

// In the umbra of a plate at the height h: what the map holds is b = H - h away, and so is the mean blocker.
// The search begins at the sphere around the plate, b0 = b - sqrt(5), but not before the near plane; its
// kernel is S (H - b0) / (2 H b0 tan), and the stage shows six times that.
static void test_stages(void **unused) {
    (void)unused;
    for (int i = 1; i <= 4; i++) {
        double h = 0.7 * i, b = CLOSED_LAMP_AT - h, x = -width_of(h) / 2 - 0.08;
        Scene scene = lamp_and_wall();
        closed_plate(&scene, h, 0);
        double far = (double)scene.lights[0].far_plane, b0 = fmax(b - sqrt(5), 2);
        check_stage(&scene, "distances", x, b / far);
        check_stage(&scene, "blockers", x, b / far);
        const double given[] = {2 * extent, CLOSED_LAMP_AT, b0, glm_deg(scene.lights[0].fov_y)};
        check_stage(&scene, "kernels", x, 6 * prediction_answer(LAB_ID, 0, given));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_ramp), cmocka_unit_test(test_kernel_of_a_texel),
                                       cmocka_unit_test(test_stages)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
