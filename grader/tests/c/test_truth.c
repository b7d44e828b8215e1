// The truth's visibility of lights against closed forms (they stand at each test).
#include "tests/helpers/truth_points.h"
#include "truth/closed_scenes.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "scene/check.h"
#include "scene/count.h"

enum { SIZE = 800, SAMPLES = 1024, TILES = 64, SEED = 5 };

// Area of the shadow of light 0 on object 0, world units, in a picture of the wall z = 0 (closed_wall).
static double shadow_area(const Scene *scene) {
    const TruthQuery query = {.kind = TRUTH_LIGHT};
    Truth truth = {0};
    TruthPicture picture = {0};
    float *visibility = calloc((size_t)SIZE * SIZE, sizeof *visibility);
    int dark = 0;
    assert_true(truth_create(&truth, scene) && truth_picture_create(&picture, SIZE, SIZE));
    truth_look(&truth, &picture);
    assert_true(truth_trace(&truth, &picture, &query, visibility));
    for (int i = 0; i < SIZE * SIZE; i++)
        dark += picture.hits[i].object == 0 && visibility[i] < 0.5f;
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
    free(visibility);
    double unit = closed_unit(scene, SIZE);
    return dark * unit * unit;
}

// A point light at height H over a plane, a sphere of radius r at distance d whose direction is tilted by
// theta from the normal: an ellipse with the half axes H sin a cos a / Q and H sin a / sqrt Q, sin a = r / d,
// Q = cos^2 theta - sin^2 a. The mesh is inscribed in the sphere and holds a sphere of radius r cos^2(pi /
// 32), whose shadow is the lower bound. Counting pixels is wrong by at most half a pixel's diagonal along the
// outline (at most 2 pi semi-major).
static double ellipse(double light_height, double r, double d, double cos_theta, double *outline) {
    double sin_a = r / d, q = cos_theta * cos_theta - sin_a * sin_a;
    double major = light_height * sin_a * sqrt(1 - sin_a * sin_a) / q, minor = light_height * sin_a / sqrt(q);
    *outline = 2 * GLM_PI * fmax(major, minor);
    return GLM_PI * major * minor;
}

static void test_sphere(void **unused) {
    (void)unused;
    const float light_height = 4, r = 0.5f;
    const vec3s light = vec3_make(-3.5f, 0, light_height), center = vec3_make(-1.5f, 0, 1.6f);
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_SPHERE, center, vec3_make(r, r, r), 0);
    closed_light(&scene, LIGHT_SPOT, light, vec3_make(0, 0, 0), glm_rad(80), 0, 1, 8);
    double d = glms_vec3_distance(light, center), cos_theta = (light.z - center.z) / d, outline;
    double low = ellipse(light_height, r * pow(cos(GLM_PI / 32), 2), d, cos_theta, &outline);
    double high = ellipse(light_height, r, d, cos_theta, &outline);
    double pixels = outline * closed_unit(&scene, SIZE) * sqrt(0.5), measured = shadow_area(&scene);
    print_message("sphere: %.4f, expected %.4f to %.4f, pixels %.4f\n", measured, low, high, pixels);
    assert_true(measured > low - pixels && measured < high + pixels);
}

// A directional light whose rays are tilted by theta: area pi r^2 / cos theta; bounds as above (the outline
// is an ellipse with the half axes r and r / cos theta).
static void test_directional_sphere(void **unused) {
    (void)unused;
    const float r = 0.5f;
    Scene scene = closed_wall(6, 10, glm_rad(40));
    closed_add(&scene, SHAPE_SPHERE, vec3_make(-1.8f, 0, 1.6f), vec3_make(r, r, r), 0);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(-4, 0, 4), vec3_make(0, 0, 0), 0, 4, 1, 12);
    double cos_theta = sqrt(0.5), high = GLM_PI * r * r / cos_theta, low = high * pow(cos(GLM_PI / 32), 4);
    double pixels = 2 * GLM_PI * r / cos_theta * closed_unit(&scene, SIZE) * sqrt(0.5);
    double measured = shadow_area(&scene);
    print_message("directional: %.4f, expected %.4f to %.4f, pixels %.4f\n", measured, low, high, pixels);
    assert_true(measured > low - pixels && measured < high + pixels);
}

// A square of side a, parallel to the plane at height h, under a point light at height H: area a^2 (H / (H -
// h))^2. A one-sided plane, once facing the light and once turned away: both block. Pixels: half of one along
// the outline.
static void test_square(void **unused) {
    (void)unused;
    const float light_height = 4, h = 2, side = 1;
    for (int turned = 0; turned < 2; turned++) {
        Scene scene = closed_wall(6, 10, glm_rad(40));
        mat4s placed = glms_rotate(glms_translate_make(vec3_make(-0.9f, 0, h)), glm_rad(turned ? -90 : 90),
                                   vec3_make(1, 0, 0));
        truth_point_add(&scene, SHAPE_PLANE, glms_scale(placed, vec3_make(side / 2, 1, side / 2)));
        closed_light(&scene, LIGHT_SPOT, vec3_make(-3, 0, light_height), vec3_make(1.2f, 0, 0), glm_rad(90),
                     0, 1, 8);
        double ratio = light_height / (light_height - h), expected = side * side * ratio * ratio;
        double pixels = 4 * side * ratio * closed_unit(&scene, SIZE) / 2, measured = shadow_area(&scene);
        print_message("square: %.4f, expected %.4f, pixels %.4f\n", measured, expected, pixels);
        assert_true(fabs(measured - expected) < pixels);
    }
}

enum { OCCLUDER_HEIGHT = 1, LIGHT_HEIGHT = 4 };

// A sheet at height 1 over x < 0 that shades the plane z = 0 from a light at height 4.
static Scene half_plane(void) {
    Scene scene = {0};
    mat4s placed =
        glms_rotate(glms_translate_make(vec3_make(-50, 0, OCCLUDER_HEIGHT)), glm_rad(90), vec3_make(1, 0, 0));
    truth_point_add(&scene, SHAPE_PLANE, glms_scale(placed, vec3_make(50, 1, 50)));
    return scene;
}

static double area_visibility(TruthKind kind, float x, float radius) {
    Scene scene = half_plane();
    const TruthQuery query = {
        .kind = kind,
        .area = {vec3_make(0, 0, LIGHT_HEIGHT), vec3_make(radius, 0, 0), vec3_make(0, radius, 0)},
        .samples = SAMPLES,
        .seed = SEED};
    return truth_point(&scene, vec3_make(x, 0, 0), vec3_make(0, 0, 1), &query, TILES);
}

// A disc of radius R above the edge: V(t) = 1/2 + (t sqrt(1 - t^2) + asin t) / pi, t = x / w; a rectangle
// with the half side R: 1/2 + t/2. Half the penumbra's width: w = R (d_r - d_o) / d_o, with the receiver d_r
// = 4 and the occluder d_o = 3 from the light.
static void test_penumbra(void **unused) {
    (void)unused;
    const double radius = 0.6, w = radius * OCCLUDER_HEIGHT / (LIGHT_HEIGHT - OCCLUDER_HEIGHT);
    print_message("seed %d\n", SEED);
    for (int i = -9; i <= 9; i++) {
        double t = i / 10.0, disc = 0.5 + (t * sqrt(1 - t * t) + asin(t)) / GLM_PI, rectangle = 0.5 + t / 2;
        double measured = area_visibility(TRUTH_DISC, (float)(t * w), (float)radius);
        assert_true(fabs(measured - disc) < truth_point_noise(disc, SAMPLES * TILES));
        measured = area_visibility(TRUTH_RECTANGLE, (float)(t * w), (float)radius);
        assert_true(fabs(measured - rectangle) < truth_point_noise(rectangle, SAMPLES * TILES));
    }
}

// The whole penumbra of a light of size S is S (d_r - d_o) / d_o wide. A stratum is 2 / 32 of the rectangle
// wide: 1/32 of the width beyond either end all samples agree, as much before it some of the edge's 32 strata
// differ.
static void test_penumbra_width(void **unused) {
    (void)unused;
    const double size = 1.2, width = size * OCCLUDER_HEIGHT / (LIGHT_HEIGHT - OCCLUDER_HEIGHT);
    const double step = width / 32;
    assert_true(area_visibility(TRUTH_RECTANGLE, (float)(-width / 2 - step), (float)size / 2) == 0);
    assert_true(area_visibility(TRUTH_RECTANGLE, (float)(-width / 2 + step), (float)size / 2) > 0);
    assert_true(area_visibility(TRUTH_RECTANGLE, (float)(width / 2 - step), (float)size / 2) < 1);
    assert_true(area_visibility(TRUTH_RECTANGLE, (float)(width / 2 + step), (float)size / 2) == 1);
}

// The same width, when the size is the scene's lamp's own: the half side R of a square that looks down, whose
// axes are a unit long. The sky is above a spot light and a point light alike; behind it, only the latter
// shines.
static void test_lamp_with_an_extent(void **unused) {
    (void)unused;
    const double radius = 0.6, w = radius * OCCLUDER_HEIGHT / (LIGHT_HEIGHT - OCCLUDER_HEIGHT);
    const TruthQuery query = {.kind = TRUTH_LIGHT, .samples = SAMPLES, .seed = SEED};
    print_message("seed %d\n", SEED);
    for (int kind = LIGHT_SPOT; kind <= LIGHT_POINT; kind += LIGHT_POINT - LIGHT_SPOT)
        for (int i = -9; i <= 9; i++) {
            Scene scene = half_plane();
            closed_light(&scene, (LightKind)kind, vec3_make(0, 0, LIGHT_HEIGHT), vec3_make(0, 0, 0), 1, 0, 1,
                         8);
            scene.lights[0].extent = (float)radius;
            double t = i / 10.0, expected = 0.5 + t / 2;
            double measured =
                truth_point(&scene, vec3_make((float)(t * w), 0, 0), vec3_make(0, 0, 1), &query, TILES);
            assert_true(fabs(measured - expected) < truth_point_noise(expected, SAMPLES * TILES));
            double behind =
                truth_point(&scene, vec3_make(0.1f, 0, LIGHT_HEIGHT + 1), vec3_make(0, 0, -1), &query, 1);
            assert_true(behind == (kind == LIGHT_POINT));
        }
}

// A lamp at height 4 that looks to +x lights x > 0 only; a second one that the sheet hides from the point, a
// third one that it does not.
static void test_lights(void **unused) {
    (void)unused;
    Scene scene = half_plane();
    closed_light(&scene, LIGHT_SPOT, vec3_make(1, 0, LIGHT_HEIGHT), vec3_make(9, 0, LIGHT_HEIGHT), 1, 0, 1,
                 8);
    closed_light(&scene, LIGHT_SPOT, vec3_make(-3, 0, LIGHT_HEIGHT), vec3_make(0, 0, 0), 1, 0, 1, 8);
    closed_light(&scene, LIGHT_DIRECTIONAL, vec3_make(0, 0, LIGHT_HEIGHT), vec3_make(0, 0, 0), 0, 4, 1, 8);
    const vec3s up = vec3_make(0, 0, 1);
    const double expected[2][3] = {{0, 0, 1}, {1, 1, 1}};
    const float place[2] = {0.5f, 2.5f};
    for (int p = 0; p < 2; p++) {
        for (int light = 0; light < 3; light++)
            assert_true(truth_point(&scene, vec3_make(place[p], 0, 0), up,
                                    &(TruthQuery){.kind = TRUTH_LIGHT, .light = light},
                                    1) == expected[p][light]);
        double all =
            truth_point(&scene, vec3_make(place[p], 0, 0), up, &(TruthQuery){.kind = TRUTH_LIGHTS}, 1);
        assert_true(fabs(all - (p ? 1 : 1 / 3.0)) < 1e-6);
    }
}

// A sphere before a wall, seen slantwise: 67 x 45 pixels, so that the last tiles are not full.
static void trace_frame(const TruthQuery *query, float *visibility) {
    Scene scene = closed_wall(3, 10, glm_rad(40));
    scene.camera.eye = vec3_make(3, 1, 8);
    closed_add(&scene, SHAPE_SPHERE, vec3_make(0, 0, 1), vec3_make(0.5f, 0.5f, 0.5f), 0);
    Truth truth = {0};
    TruthPicture picture = {0};
    assert_true(truth_create(&truth, &scene) && truth_picture_create(&picture, 67, 45));
    truth_look(&truth, &picture);
    assert_true(truth_trace(&truth, &picture, query, visibility));
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
}

// The same seed gives the same bytes, another one others; one ray at a time meets the same but for rays that
// pass an edge within a rounding: at most one in 10,000.
static void test_seeds(void **unused) {
    (void)unused;
    enum { PIXELS = 67 * 45 };
    static float first[PIXELS], again[PIXELS], other[PIXELS], singly[PIXELS];
    TruthQuery query = {.kind = TRUTH_OCCLUSION, .samples = 64, .seed = SEED};
    trace_frame(&query, first);
    trace_frame(&query, again);
    query.one_by_one = true;
    trace_frame(&query, singly);
    query.seed++;
    trace_frame(&query, other);
    assert_memory_equal(first, again, sizeof first);
    assert_memory_not_equal(first, other, sizeof first);
    double difference = 0;
    for (int i = 0; i < PIXELS; i++)
        difference += fabsf(first[i] - singly[i]) / PIXELS;
    print_message("one ray at a time: %g\n", difference);
    assert_true(difference <= 1e-4);
}

// The camera looks through the back of a plane, as it does in the labs, and meets what lies behind it.
static void test_back_faces(void **unused) {
    (void)unused;
    Scene scene = closed_wall(3, 10, glm_rad(40));
    mat4s turned = glms_rotate(glms_translate_make(vec3_make(0, 0, 2)), glm_rad(-90), vec3_make(1, 0, 0));
    truth_point_add(&scene, SHAPE_PLANE, turned);
    Truth truth = {0};
    TruthPicture picture = {0};
    assert_true(truth_create(&truth, &scene) && truth_picture_create(&picture, 4, 4));
    truth_look(&truth, &picture);
    for (int i = 0; i < 16; i++)
        assert_true(picture.hits[i].object == 0 || picture.hits[i].object == TRUTH_NONE);
    assert_int_equal(picture.hits[5].object, 0);
    assert_true(fabsf(picture.hits[5].position.z) < 1e-5f &&
                picture.hits[5].position.y > 0); // row 1 lies above
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
}

static void test_refusals(void **unused) {
    (void)unused;
    Scene scene = half_plane();
    Truth truth = {0};
    TruthPicture picture = {0};
    float visibility[1];
    assert_true(truth_create(&truth, &scene) && truth_picture_create(&picture, 1, 1));
    const TruthQuery refused[] = {{.kind = TRUTH_LIGHT},
                                  {.kind = TRUTH_LIGHTS},
                                  {.kind = TRUTH_DISC},
                                  {.kind = TRUTH_RECTANGLE, .samples = -1},
                                  {.kind = TRUTH_OCCLUSION, .samples = TRUTH_MAX_SAMPLES + 1}};
    for (size_t i = 0; i < COUNT(refused); i++) {
        check_clear();
        assert_false(truth_trace(&truth, &picture, &refused[i], visibility));
        assert_true(strlen(check_message()) > 0);
    }
    check_clear();
    truth_picture_destroy(&picture);
    truth_destroy(&truth);
    truth_destroy(&truth);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sphere),
                                       cmocka_unit_test(test_directional_sphere),
                                       cmocka_unit_test(test_square),
                                       cmocka_unit_test(test_penumbra),
                                       cmocka_unit_test(test_penumbra_width),
                                       cmocka_unit_test(test_lights),
                                       cmocka_unit_test(test_lamp_with_an_extent),
                                       cmocka_unit_test(test_seeds),
                                       cmocka_unit_test(test_back_faces),
                                       cmocka_unit_test(test_refusals)};
    return cmocka_run_group_tests_name("truth", tests, NULL, NULL);
}
