// Lab 01's models on a wall under a sun, against the numbers that a student predicts.
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 64, DIFFUSE = 1, PHONG = 2 };
static const double RED = 0.6, AMBIENT = 0.2, LAMP = 0.7, SPECULAR = 0.6, SHININESS = 12;

// The wall's red where the eye looks straight at it, under a sun `angle` degrees beside the normal. The
// middle of the picture is the divider's, so a pixel of the left half beside it is taken.
static double red_of(int model, int finish, double angle) {
    Scene scene = closed_wall(6, 10, glm_rad(4));
    const float sine = (float)sin(closed_radians(angle)), cosine = (float)cos(closed_radians(angle));
    scene.objects[0].color = vec3_make((float)RED, 0, 0);
    scene.objects[0].specular = (float)SPECULAR;
    scene.objects[0].shininess = (float)SHININESS;
    scene.ambient = vec3_make((float)AMBIENT, 0, 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 5 * sine, 5 * cosine), vec3_make(0, 0, 0), 0, 5, 1,
                 10);
    scene.lights[0].color = vec3_make((float)LAMP, 0, 0);
    const WitnessKnob knobs[] = {{"left model", (float)model}, {"finish", (float)finish}};
    Image image = witness_draw(LAB_ID, &scene, "picture", SIZE, SIZE, knobs, 2);
    const double red = image.rgba[4 * (SIZE / 2 * SIZE + SIZE / 2 - 3)] / 255.0;
    image_destroy(&image);
    return red;
}

// The eye looks along the normal, so it is as far beside the reflected ray as the sun beside the normal.
// Three pixels beside the middle that is 0.3 degrees off, which the highlight changes by less than a
// hundredth.
static void test_models(void **unused) {
    (void)unused;
    for (int angle = 10; angle <= 40; angle += 10) {
        const double diffuse = red_of(DIFFUSE, 0, angle), phong = red_of(PHONG, 0, angle);
        const double matt = prediction_answer(LAB_ID, 0, (const double[4]){RED, AMBIENT, LAMP, angle});
        const double light =
            prediction_answer(LAB_ID, 1, (const double[4]){LAMP, SPECULAR, SHININESS, angle});
        print_message("%d degrees: %.4f, predicted %.4f; highlight %.4f, predicted %.4f\n", angle, diffuse,
                      matt, phong - diffuse, light);
        assert_true(fabs(diffuse - matt) < 0.51 / 255);
        assert_true(fabs(phong - diffuse - light) < 0.01 || phong == 1);
    }
}

static void test_posterised(void **unused) {
    (void)unused;
    for (int angle = 15; angle <= 75; angle += 15) {
        const double plain = prediction_answer(LAB_ID, 0, (const double[4]){RED, AMBIENT, LAMP, angle});
        const double measured = red_of(DIFFUSE, 1, angle);
        assert_true(fabs(measured - prediction_answer(LAB_ID, 2, (const double[4]){plain})) < 0.51 / 255);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_models), cmocka_unit_test(test_posterised)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
