// Shadow volumes made on the CPU against those of the geometry shader: the same counts in every pixel.
#include "scene/check.h"
#include "scene/scene_parts.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

extern const SceneMaker lab_07_scenes[]; // the table of scenes.c, as build.mk names it

enum { WIDTH = 320, HEIGHT = 240, SEEDS = 1 };

static Image draw(const Scene *scene, int method, int silhouettes) {
    const WitnessKnob knobs[] = {{"method", (float)method}, {"silhouettes", (float)silhouettes}};
    return witness_draw(LAB_ID, scene, "stencil counts", WIDTH, HEIGHT, knobs, 2);
}

// Pixels of `a` whose count differs in `b`, and pairs of neighbours of `a` with different counts.
static int differences(const Image *a, const Image *b, int *edges) {
    int different = 0;
    *edges = 0;
    for (int y = 1; y < a->height; y++)
        for (int x = 1; x < a->width; x++) {
            const uint8_t *here = a->rgba + image_at(a, x, y);
            different += memcmp(here, b->rgba + image_at(b, x, y), 3) != 0;
            *edges += memcmp(here, a->rgba + image_at(a, x - 1, y), 3) != 0;
            *edges += memcmp(here, a->rgba + image_at(a, x, y - 1), 3) != 0;
        }
    return different;
}

static bool has_casters(const Scene *scene) {
    bool any = false;
    for (int i = 0; i < scene->object_count; i++)
        any = any || scene->objects[i].shape != SHAPE_PLANE;
    return any;
}

// The two round differently, by far less than the grid of 1/256 pixel that GL puts vertices on. So only where
// that grid flips a vertex to its neighbour do they differ: an edge then sweeps at most 1/256 pixel of area
// per pixel of its length. Where nothing but planes stands there is no volume, and no edge.
static void test_counts(void **unused) {
    (void)unused;
    for (int i = 0; lab_07_scenes[i].name; i++)
        for (uint64_t seed = 1; seed <= SEEDS; seed++)
            for (int method = 0; method < 2; method++) {
                Scene scene = {0};
                lab_07_scenes[i].make(&scene, &(Random){seed});
                Image shader = draw(&scene, method, 0), cpu = draw(&scene, method, 1);
                int edges, different = differences(&shader, &cpu, &edges);
                print_message("%s, seed %d, method %d: %d of %d pixels differ, %d at edges\n",
                              lab_07_scenes[i].name, (int)seed, method, different, WIDTH * HEIGHT, edges);
                assert_true((edges > 100) == has_casters(&scene) && different <= 4 + edges / 256);
                image_destroy(&shader);
                image_destroy(&cpu);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_counts)};
    return cmocka_run_group_tests_name("silhouettes", tests, NULL, NULL);
}
