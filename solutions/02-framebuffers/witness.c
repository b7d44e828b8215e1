// What lab 02's depth texture holds of a wall: its distance, by the formula that a student predicts with.
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 64 };

static double depth_of(const Scene *scene) {
    Image image = witness_draw(LAB_ID, scene, "depth texture", SIZE, SIZE, NULL, 0);
    const double depth = image.rgba[4 * (image.height / 2 * image.width + image.width / 2)] / 255.0;
    image_destroy(&image);
    return depth;
}

// The wall stands straight before the second camera. A picture has 255 steps; half of one more or less is
// other distances, between which the wall's must lie.
static void test_distance(void **unused) {
    (void)unused;
    for (int i = 1; i <= 5; i++) {
        const Scene scene = closed_wall(20, (float)i, glm_rad(40));
        const double near = (double)scene.second_camera.near_plane,
                     far = (double)scene.second_camera.far_plane;
        const double depth = depth_of(&scene), step = 0.51 / 255;
        const double least = prediction_answer(LAB_ID, 0, (const double[4]){near, far, depth - step});
        const double most = prediction_answer(LAB_ID, 0, (const double[4]){near, far, depth + step});
        print_message("wall at %d: depth %.4f, predicted %.3f to %.3f\n", i, depth, least, most);
        assert_true(least < i && i < most);
    }
}

// Half of the depths lie before the distance that is predicted: a wall a little nearer is darker than a half.
static void test_half(void **unused) {
    (void)unused;
    for (int i = -1; i <= 1; i += 2) {
        Scene scene = closed_wall(20, 4, glm_rad(40));
        Camera *camera = &scene.second_camera;
        camera->near_plane = 2.5f;
        camera->far_plane = 10;
        const double half = prediction_answer(LAB_ID, 1, (const double[4]){2.5, 10});
        camera->eye.z = (float)(half * (1 + 0.02 * i));
        const double depth = depth_of(&scene);
        print_message("wall at %.3f: depth %.4f\n", (double)camera->eye.z, depth);
        assert_true(i < 0 ? depth < 0.5 : depth > 0.5);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_distance), cmocka_unit_test(test_half)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
