// Lab 15's slices against a search for the smallest sphere, and its shadows against segments to the sun, to
// the texel of each slice.
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { WIDE = 200, HIGH = 240, MAP = 200, SLICES = 3, SHOWN = 400, PLATES = 3 };
static const double near_plane = 0.8, far_plane = 40, blend = 0.2;

typedef struct Part {
    double begin, end, centre, radius;
} Part;

// A wall as the floor of a camera that stands on it and looks along it; plates high above, each so much
// larger as it is farther away. Nothing but the wall is seen below the horizon.
static Scene long_floor(WitnessPlate *plates) {
    static const float ahead[PLATES] = {3, 8, 22};
    Scene scene = closed_wall(60, 10, glm_rad(50));
    scene.camera = (Camera){.eye = vec3_make(0.3f, -30, 1.5f),
                            .target = vec3_make(0.5f, -28, 0.9f),
                            .fov_y = glm_rad(50),
                            .near_plane = (float)near_plane,
                            .far_plane = (float)far_plane};
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(2, 1, 6), vec3_make(0, 0, 0), 0, 8, 1, 20);
    for (int i = 0; i < PLATES; i++) {
        const float up = 3 * ahead[i], half = 0.14f * ahead[i], thin = 1e-3f;
        // Its shadow falls around (0.3, ahead - 30).
        vec3s center = vec3_make(0.3f + up / 3, ahead[i] - 30 + up / 6, up);
        closed_add(&scene, SHAPE_BOX, center, vec3_make(half, half, thin), 0);
        plates[i] = (WitnessPlate){center, half};
    }
    return scene;
}

// As far as the corner farthest from a place on the axis.
static double reach(double at, double begin, double end, double k) {
    return fmax(hypot(at - begin, begin * k), hypot(at - end, end * k));
}

// The smallest sphere by a search on the axis.
static void find_smallest(Part *part, double k) {
    double low = 0, high = 2 * part->end;
    for (int step = 0; step < 100; step++) {
        double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (reach(a, part->begin, part->end, k) < reach(b, part->begin, part->end, k))
            high = b;
        else
            low = a;
    }
    part->centre = (low + high) / 2;
    part->radius = reach(part->centre, part->begin, part->end, k);
}

// By Zhang et al. 2006.
static Part part_of(const Scene *scene, double aspect, double lambda, int i) {
    const double k = tan((double)scene->camera.fov_y / 2) * hypot(1, aspect);
    double borders[SLICES + 1];
    for (int b = 0; b <= SLICES; b++) {
        double share = b / (double)SLICES;
        borders[b] = lambda * near_plane * pow(far_plane / near_plane, share) +
                     (1 - lambda) * (near_plane + (far_plane - near_plane) * share);
    }
    Part part = {.begin = borders[i] - (i > 0 ? blend * (borders[i] - borders[i - 1]) : 0),
                 .end = borders[i + 1]};
    find_smallest(&part, k);
    return part;
}

static Image draw(const Scene *scene, const char *view, int width, int height, double lambda) {
    const WitnessKnob knobs[] = {
        {"slices", SLICES}, {"lambda", (float)lambda}, {"map size", MAP}, {"blend", (float)blend}};
    return witness_draw(LAB_ID, scene, view, width, height, knobs, 4);
}

// The stage draws a tile of SHOWN / 2 pixels for each slice, three times its end wide: what is not black is
// the sphere, but for a pixel along its outline.
static void test_spheres(void **unused) {
    (void)unused;
    WitnessPlate plates[PLATES];
    const Scene scene = long_floor(plates);
    for (int step = 0; step <= 4; step++) {
        Image image = draw(&scene, "spheres", SHOWN, SHOWN, step / 4.0);
        int wrong = 0;
        for (int i = 0; i < SLICES; i++) {
            const Part part = part_of(&scene, 1, step / 4.0, i);
            const double pixel = 3 * part.end / (SHOWN / 2.0);
            for (int y = 0; y < SHOWN / 2; y++)
                for (int x = 0; x < SHOWN / 2; x++) {
                    const uint8_t *rgba = &image.rgba[image_at(&image, i % 2 * SHOWN / 2 + x,
                                                               SHOWN - 1 - i / 2 * SHOWN / 2 - y)];
                    double right = pixel * (x + 0.5) - 0.5 * part.end,
                           up = pixel * (y + 0.5) - 1.5 * part.end;
                    double inside = part.radius - hypot(right - part.centre, up);
                    wrong += fabs(inside) > pixel && (rgba[2] > 0) != (inside > 0);
                }
        }
        print_message("lambda %.2f: %d pixels wrong\n", step / 4.0, wrong);
        assert_int_equal(wrong, 0);
        image_destroy(&image);
    }
}

// The place on the wall behind a pixel; false above the horizon and beyond the far plane.
static bool on_wall(const Scene *scene, int x, int y, vec3s *place, double *depth) {
    const Camera *camera = &scene->camera;
    mat4s clip_from_world =
        glms_mat4_mul(camera_clip_from_view(camera, (float)WIDE / HIGH), camera_view_from_world(camera));
    vec4s far_clip = {{2 * ((float)x + 0.5f) / WIDE - 1, 1 - 2 * ((float)y + 0.5f) / HIGH, 1, 1}};
    vec4s end = glms_mat4_mulv(glms_mat4_inv(clip_from_world), far_clip);
    vec3s way = glms_vec3_sub(vec3_make(end.x / end.w, end.y / end.w, end.z / end.w), camera->eye);
    float t = -camera->eye.z / way.z;
    *place = glms_vec3_muladds(way, t, camera->eye);
    *depth = t * far_plane;
    return t > 0 && t < 0.99f;
}

// A map that is asked at its nearest texel is right where the segment to the sun passes the plates' edges by
// half of a texel's diagonal, as it lies on a plate: the sun's rays meet it at the angle theta from its
// normal. In a blend the coarser of both maps counts.
static void test_shadows(void **unused) {
    (void)unused;
    WitnessPlate plates[PLATES];
    const Scene scene = long_floor(plates);
    const vec3s to_sun = glms_vec3_sub(scene.lights[0].position, scene.lights[0].target);
    const double cosine = (double)to_sun.z / (double)glms_vec3_norm(to_sun);
    for (int step = 0; step <= 2; step++) {
        const double lambda = step / 2.0;
        Image image = draw(&scene, "visibility", WIDE, HIGH, lambda);
        int lit = 0, dark = 0, wrong = 0;
        for (int i = 0; i < WIDE * HIGH; i++) {
            vec3s place;
            double depth, texel = 0;
            if (!on_wall(&scene, i % WIDE, i / WIDE, &place, &depth))
                continue;
            for (int k = 0; k < SLICES; k++) {
                const Part part = part_of(&scene, (double)WIDE / HIGH, lambda, k);
                if (depth >= part.begin && depth <= part.end)
                    texel = 2 * part.radius / (MAP - 2);
            }
            const float margin = (float)(texel * M_SQRT1_2 / cosine * 1.01);
            const vec3s end = glms_vec3_muladds(to_sun, 100, place);
            const int value = image.rgba[image_at(&image, i % WIDE, i / WIDE)];
            if (witness_cuts(plates, PLATES, place, end, -margin)) {
                dark++;
                wrong += value > 0;
            } else if (!witness_cuts(plates, PLATES, place, end, margin)) {
                lit++;
                wrong += value < 255;
            }
        }
        print_message("lambda %.1f: %d dark, %d lit, %d wrong\n", lambda, dark, lit, wrong);
        assert_true(dark > 300 && lit > 3000);
        assert_int_equal(wrong, 0);
        image_destroy(&image);
    }
}

// What students predict: a texel against the search, narrow views and wide ones; a border against the mean of
// both planes, which is the geometric one for lambda = 1, and the arithmetic one for 0.
static void test_predictions(void **unused) {
    (void)unused;
    for (int tenths = 4; tenths <= 12; tenths++) {
        const double k = tenths / 10.0;
        Part part = {.begin = 2, .end = 8};
        find_smallest(&part, k);
        const double given[] = {part.begin, part.end - part.begin, k, 256};
        assert_true(fabs(prediction_answer(LAB_ID, 1, given) - 2 * part.radius / 254) < 1e-9);
    }
    assert_true(fabs(prediction_answer(LAB_ID, 0, (const double[]){0.5, 32, 1, 2}) - 4) < 1e-12);
    assert_true(fabs(prediction_answer(LAB_ID, 0, (const double[]){0.5, 32, 0, 2}) - 16.25) < 1e-12);
    assert_true(fabs(prediction_answer(LAB_ID, 0, (const double[]){0.5, 32, 0.25, 2}) - 13.1875) < 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_spheres), cmocka_unit_test(test_shadows),
                                       cmocka_unit_test(test_predictions)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
