// Lab 16's light against closed forms: one plate before a wall, and two. The lamp looks straight at the wall,
// so that all depths of a plane are one; far aside, so that the plates do not hide their shadows from the
// eye.
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 400, MAP = 1024, BLUR = 8 };
static Image draw(const Scene *scene, double cut) {
    const WitnessKnob knobs[] = {
        {"map size", MAP}, {"blur", BLUR}, {"mipmaps", 0}, {"least variance", 1}, {"cut", (float)cut}};
    return witness_draw(LAB_ID, scene, "visibility", SIZE, SIZE, knobs, 5);
}

// The light of a share q: one plate and the wall; or an upper plate, a above a lower one that hides the wall,
// b below it.
static double one_plate(double q, double a, double b) {
    (void)a, (void)b;
    return 1 - q;
}

static double two_plates(double q, double a, double b) {
    const double variance = prediction_answer(LAB_ID, 0, (const double[4]){q, 0, a}), beyond = b + q * a,
                 light = prediction_answer(LAB_ID, 1, (const double[4]){q, a, b});
    assert_true(fabs(light - variance / (variance + beyond * beyond)) < 1e-12);
    return light;
}

// Around x = 0, where the upper plate's shadow ends: the filter, 2 r + 1 texels and a lookup between two of
// them, sees the plate in a share q = 1/2 - x / width; one texel and a half to either side says how far that
// may be off.
static void compare(const Scene *scene, const char *what, double (*light)(double q, double a, double b),
                    double a, double b, double from) {
    const double texel = closed_lamp_texel(MAP), width = (2 * BLUR + 1) * texel;
    Image image = draw(scene, 0);
    double unit = closed_unit(scene, SIZE), worst = 0;
    int places = 0;
    for (int column = SIZE / 2 + (int)(from / unit); column < SIZE / 2 + (int)(0.2 / unit); column++) {
        double x = (column + 0.5 - SIZE / 2.0) * unit, least = 2, most = -1;
        for (int i = -6; i <= 6; i++) {
            double q = fmin(fmax(0.5 - (x + 0.25 * i * texel) / width, 0), 1), p = light(q, a, b);
            least = fmin(least, p);
            most = fmax(most, p);
        }
        double lit = image.rgba[image_at(&image, column, SIZE / 2)] / 255.0;
        worst = fmax(worst, fmax(least - lit, lit - most));
        places++;
    }
    print_message("%s, a = %.1f, b = %.1f: %d places, at most %.4f off\n", what, a, b, places, worst);
    assert_true(places > 20 && worst <= 1.0 / 255);
    image_destroy(&image);
}

static void test_one(void **unused) {
    (void)unused;
    for (int i = 1; i <= 4; i++) {
        Scene scene = closed_wall_and_lamp(SIZE, SIZE);
        closed_plate(&scene, 0.7 * i, 0);
        compare(&scene, "one plate", one_plate, 0.7 * i, 0, -0.2);
    }
}

// The eye sees the wall from x = -0.2 on beside a lower plate whose shadow ends at 0.6. A cut at a^2 / (a + 2
// b)^2 leaves nothing of the light.
static void test_two(void **unused) {
    (void)unused;
    for (int i = 1; i <= 4; i++) {
        const double b = 1, a = 0.7 * i;
        Scene scene = closed_wall_and_lamp(SIZE, SIZE);
        closed_plate(&scene, b + a, 0);
        closed_plate(&scene, b, 0.6);
        compare(&scene, "two plates", two_plates, a, b, -0.1);
        Image image = draw(&scene, a * a / ((a + 2 * b) * (a + 2 * b)) + 0.002);
        int most = 0;
        for (int column = SIZE / 2 - 12; column < SIZE / 2 + 25; column++)
            most = image.rgba[image_at(&image, column, SIZE / 2)] > most
                       ? image.rgba[image_at(&image, column, SIZE / 2)]
                       : most;
        print_message("with the cut: at most %d\n", most);
        assert_int_equal(most, 0);
        image_destroy(&image);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_one), cmocka_unit_test(test_two)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
