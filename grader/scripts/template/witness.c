// The pictures of this lab's solution against closed forms (they stand at each test).
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SIZE = 64 };

// A bare wall that fills the picture and faces the lamp is lit everywhere.
static void test_wall(void **unused) {
    (void)unused;
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_light(&scene, LIGHT_SPOT, vec3_make(0, 0, 8), vec3_make(0, 0, 0), 1, 0, 1, 20);
    Image image = witness_draw(LAB_ID, &scene, "visibility", SIZE, SIZE, NULL, 0);
    for (int i = 0; i < SIZE * SIZE; i++)
        assert_int_equal(image.rgba[4 * i], 255);
    image_destroy(&image);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_wall)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
