// The truth's ambient occlusion against closed forms: the share of the cosine-weighted hemisphere that is
// blocked. The receiver is the origin with the normal +z. Noise: four standard errors of independent rays
// (truth_point_noise).
#include "tests/helpers/truth_points.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { SAMPLES = 1024, TILES = 512, RAYS = SAMPLES * TILES, SEED = 3 };

static const float far_away = 1000;

static mat4s place(vec3s center, float degrees, vec3s axis, vec3s half_size) {
    mat4s placed = glms_rotate(glms_translate_make(center), glm_rad(degrees), axis);
    return glms_scale(placed, half_size);
}

// A wall over the line x = `x`, `height` high, that reaches far to both sides.
static void add_wall(Scene *scene, float x, float height) {
    const vec3s center = vec3_make(x, 0, height / 2), half_size = vec3_make(far_away, 1, height / 2);
    truth_point_add(scene, SHAPE_PLANE, place(center, 90, vec3_make(0, 0, 1), half_size));
}

static double occlusion(const Scene *scene, float limit) {
    const TruthQuery query = {.kind = TRUTH_OCCLUSION, .samples = SAMPLES, .limit = limit, .seed = SEED};
    return 1 - truth_point(scene, vec3_make(0, 0, 0), vec3_make(0, 0, 1), &query, TILES);
}

static void check(const char *name, double measured, double low, double high) {
    double noise = truth_point_noise((low + high) / 2, RAYS);
    print_message("%s: %.5f, expected %.5f to %.5f, noise %.5f, seed %d\n", name, measured, low, high, noise,
                  SEED);
    assert_true(measured > low - noise && measured < high + noise);
}

static void test_open_sky(void **unused) {
    (void)unused;
    Scene scene = {0};
    truth_point_add(&scene, SHAPE_PLANE,
                    place(vec3_make(0, 0, 0), 90, vec3_make(1, 0, 0), vec3_make(9, 1, 9)));
    assert_true(occlusion(&scene, 0) == 0); // the plane on which the point lies does not block
}

// Disc of radius R at height h: R^2 / (R^2 + h^2). Here the mesh of a sphere pressed flat: its outline is a
// 32-gon between the circles of radius R cos(pi / 32) and R, and its lower half hangs by 0.001 R below its
// centre.
static void test_disc(void **unused) {
    (void)unused;
    const double radius = 1, height = 1.5, thin = 0.001, inner = radius * cos(GLM_PI / 32);
    Scene scene = {0};
    truth_point_add(
        &scene, SHAPE_SPHERE,
        place(vec3_make(0, 0, (float)height), 90, vec3_make(1, 0, 0), vec3_make(1, (float)thin, 1)));
    double low = inner * inner / (inner * inner + height * height), near_height = height - thin;
    check("disc", occlusion(&scene, 0), low, radius * radius / (radius * radius + near_height * near_height));
}

// Sphere of radius r at distance d, its centre at the angle b from the normal, all above the horizon: (r/d)^2
// cos b. The mesh holds a sphere of radius r cos^2(pi / 32): steps of 2 pi / 32 both ways, flat facets
// between them.
static void test_sphere(void **unused) {
    (void)unused;
    const float r = 0.8f, d = 2, b = glm_rad(40);
    Scene scene = {0};
    truth_point_add(&scene, SHAPE_SPHERE,
                    place(vec3_make(d * sinf(b), 0, d * cosf(b)), 0, vec3_make(0, 0, 1), vec3_make(r, r, r)));
    double expected = (double)r * r / (d * d) * cosf(b);
    check("sphere", occlusion(&scene, 0), expected * pow(cos(GLM_PI / 32), 4), expected);
}

// Wall of height h at distance x: (1 - x / sqrt(x^2 + h^2)) / 2. Its ends are 1000 away: they let pass what a
// hemisphere's edge of x / 1000 sees.
static void test_wall(void **unused) {
    (void)unused;
    const double x = 0.7, h = 1.3;
    Scene scene = {0};
    add_wall(&scene, (float)x, (float)h);
    double expected = (1 - x / sqrt(x * x + h * h)) / 2;
    check("wall of height 1.3", occlusion(&scene, 0), expected - x / far_away, expected);
}

// A wall without end: 1/2. This one is 1000 high; see test_wall for what passes above it.
static void test_infinite_wall(void **unused) {
    (void)unused;
    const double x = 0.5;
    Scene scene = {0};
    add_wall(&scene, (float)x, far_away);
    check("infinite wall", occlusion(&scene, 0), 0.5 - 2 * x / far_away, 0.5);
}

// The same with rays of length R, c = x / R: (acos c - c sqrt(1 - c^2)) / pi.
static void test_limited_wall(void **unused) {
    (void)unused;
    const double x = 0.5, limit = 1.25, c = x / limit;
    Scene scene = {0};
    add_wall(&scene, (float)x, far_away);
    double expected = (acos(c) - c * sqrt(1 - c * c)) / GLM_PI;
    check("infinite wall, rays of 1.25", occlusion(&scene, (float)limit), expected, expected);
}

// Two walls at right angles: 3/4.
static void test_corner(void **unused) {
    (void)unused;
    Scene scene = {0};
    add_wall(&scene, 0.5f, far_away);
    truth_point_add(&scene, SHAPE_PLANE,
                    place(vec3_make(0, 0.5f, 0), 0, vec3_make(0, 0, 1), vec3_make(far_away, 1, far_away)));
    check("corner", occlusion(&scene, 0), 0.75 - 4 * 0.5 / far_away, 0.75);
}

// A half-plane that rises from the receiver's plane close by and encloses the angle phi with it: (1 + cos
// phi) / 2.
static void test_wedge(void **unused) {
    (void)unused;
    const float x = 0.5f;
    for (int degrees = 30; degrees <= 150; degrees += 40) {
        float phi = glm_rad((float)degrees);
        // The receiver lies on -x of the edge; the half-plane leaves the edge along (-cos phi, 0, sin phi).
        vec3s along = vec3_make(-cosf(phi), 0, sinf(phi));
        vec3s center = glms_vec3_add(vec3_make(x, 0, 0), glms_vec3_scale(along, far_away / 2));
        Scene scene = {0};
        mat4s upright =
            place(vec3_make(0, 0, 0), 90, vec3_make(1, 0, 0), vec3_make(far_away / 2, 1, far_away));
        mat4s turned = place(center, 180 + (float)degrees, vec3_make(0, 1, 0), vec3_make(1, 1, 1));
        truth_point_add(&scene, SHAPE_PLANE, glms_mat4_mul(turned, upright));
        double expected = (1 + cos(phi)) / 2;
        print_message("%d degrees, ", degrees);
        check("wedge", occlusion(&scene, 0), expected - 2 * x / far_away, expected);
    }
}

// A polygon above the horizon: 1 / (2 pi) sum over its edges of the angle that the edge is seen under times
// the component along the normal of the unit vector normal to the plane through the edge and the point
// (Lambert 1760).
static double edge_sum(const vec3s *corners, int count) {
    double sum = 0;
    for (int i = 0; i < count; i++) {
        vec3s a = glms_vec3_normalize(corners[i]), b = glms_vec3_normalize(corners[(i + 1) % count]);
        vec3s across = glms_vec3_cross(a, b);
        sum += atan2(glms_vec3_norm(across), glms_vec3_dot(a, b)) * across.z / glms_vec3_norm(across);
    }
    return fabs(sum) / (2 * GLM_PI);
}

static void test_rectangle(void **unused) {
    (void)unused;
    mat4s placed = place(vec3_make(0.6f, -0.3f, 1.4f), -40, glms_vec3_normalize(vec3_make(1, 2, 0.5f)),
                         vec3_make(0.8f, 1, 0.5f));
    const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    vec3s corners[4];
    for (int i = 0; i < 4; i++) {
        corners[i] = glms_mat4_mulv3(placed, vec3_make(corner[i][0], 0, corner[i][1]), 1);
        assert_true(corners[i].z > 0);
    }
    Scene scene = {0};
    truth_point_add(&scene, SHAPE_PLANE, placed);
    double expected = edge_sum(corners, 4);
    check("rectangle", occlusion(&scene, 0), expected, expected);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_open_sky),      cmocka_unit_test(test_disc),
        cmocka_unit_test(test_sphere),        cmocka_unit_test(test_wall),
        cmocka_unit_test(test_infinite_wall), cmocka_unit_test(test_limited_wall),
        cmocka_unit_test(test_corner),        cmocka_unit_test(test_wedge),
        cmocka_unit_test(test_rectangle)};
    return cmocka_run_group_tests_name("truth: ambient occlusion", tests, NULL, NULL);
}
