// Lab 09's silhouettes against what is known of any closed mesh, its count against rays, and its shadows
// against areas worked out by hand.
#define SOLUTION
#include "extrude.h"

#include "scene/ray.h"
#include "predict/prediction.h"
#include "tests/helpers/witness.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { LIGHTS = 300, MOST = 4096, SIZE = 400 };

static Caster caster;
static Mesh mesh;
static Edge edges[2][MOST];

// The shape as it is, measured from an eye.
static void begin(Shape shape) {
    Adjacency adjacency;
    assert_true(mesh_create(&mesh, shape) && adjacency_create(&adjacency, &mesh));
    size_t corners = (size_t)mesh.index_count, vertices = (size_t)mesh.vertex_count;
    caster = (Caster){.triangle_count = mesh.index_count / 3,
                      .vertex_count = mesh.vertex_count,
                      .corners = malloc(corners * sizeof *caster.corners),
                      .neighbours = malloc(corners * sizeof *caster.neighbours),
                      .places = malloc(vertices * sizeof *caster.places),
                      .lit = malloc(corners * sizeof *caster.lit)};
    for (size_t i = 0; i < corners; i++)
        caster.corners[i] = adjacency.indices[2 * i];
    assert_true(find_neighbours(&caster));
    adjacency_destroy(&adjacency);
}

static void end(void) {
    caster_destroy(&caster);
    mesh_destroy(&mesh);
}

static void look(const Light *light, vec3s eye) {
    caster.light = *light;
    caster.light.position = glms_vec3_sub(light->position, eye);
    caster.light.target = glms_vec3_sub(light->target, eye);
    for (int i = 0; i < caster.vertex_count; i++)
        caster.places[i] = glms_vec3_sub(mesh.vertices[i].position, eye);
    for (int t = 0; t < caster.triangle_count; t++)
        caster.lit[t] =
            faces_light(&caster.light, corner(&caster, t, 0), corner(&caster, t, 1), corner(&caster, t, 2));
}

static vec3s any_place(Random *random, float most) {
    float x = random_range(random, -most, most), y = random_range(random, -most, most);
    return vec3_make(x, y, random_range(random, -most, most));
}

static bool has(const EdgeSet *set, Edge edge) {
    for (int i = 0; i < set->count; i++)
        if (set->edges[i].a == edge.a && set->edges[i].b == edge.b)
            return true;
    return false;
}

// As many edges leave each vertex as arrive.
static void check_ways(const EdgeSet *set) {
    for (int v = 0; v < caster.vertex_count; v++) {
        int balance = 0;
        for (int i = 0; i < set->count; i++)
            balance += (set->edges[i].a == (uint32_t)v) - (set->edges[i].b == (uint32_t)v);
        assert_int_equal(balance, 0);
    }
}

// Of a box whose sides see a light outside of it: one makes a silhouette of 4 edges, two or three one of 6.
static int count_box_edges(vec3s light) {
    int sides = (fabsf(light.x) > 1) + (fabsf(light.y) > 1) + (fabsf(light.z) > 1);
    return sides == 0 ? 0 : (int)prediction_answer(LAB_ID, 1, (const double[4]){sides});
}

static void test_silhouettes(void **unused) {
    (void)unused;
    const Shape shapes[] = {SHAPE_BOX, SHAPE_ARCH, SHAPE_SPHERE};
    Random random = {9};
    print_message("seed 9\n");
    for (int s = 0; s < 3; s++) {
        begin(shapes[s]);
        for (int n = 0; n < LIGHTS; n++) {
            Light light = {.kind = LIGHT_POINT, .position = any_place(&random, 3)};
            look(&light, vec3_make(0, 0, 0));
            EdgeSet by_set = {edges[0], 0}, by_neighbours = {edges[1], 0};
            find_by_set(&by_set, &caster);
            find_by_neighbours(&by_neighbours, &caster);
            assert_int_equal(by_set.count, by_neighbours.count);
            for (int i = 0; i < by_set.count; i++)
                assert_true(has(&by_neighbours, by_set.edges[i]));
            check_ways(&by_set);
            if (shapes[s] == SHAPE_BOX)
                assert_int_equal(by_set.count, count_box_edges(light.position));
        }
        end();
    }
}

// A box holds the eye in its shadow when it cuts the way from the eye to the light, once. A lamp in it lights
// none of its faces from outside, and an eye in it is in no case.
static void test_rays(void **unused) {
    (void)unused;
    Random random = {10};
    Scene scene = {.object_count = 1,
                   .objects = {{.shape = SHAPE_BOX, .world_from_object = glms_mat4_identity()}}};
    int shaded = 0;
    print_message("seed 10\n");
    begin(SHAPE_BOX);
    for (int n = 0; n < 10 * LIGHTS; n++) {
        Light light = {.kind = n % 2 ? LIGHT_POINT : LIGHT_DIRECTIONAL, .position = any_place(&random, 4)};
        vec3s eye = any_place(&random, 4), way;
        light.target = any_place(&random, 4);
        bool inside = !count_box_edges(eye) || (n % 2 && !count_box_edges(light.position));
        way = glms_vec3_sub(light.position, n % 2 ? eye : light.target);
        if (inside)
            continue;
        look(&light, eye);
        bool cut = ray_hits(&scene, eye, glms_vec3_normalize(way), n % 2 ? glms_vec3_norm(way) : INFINITY);
        assert_int_equal(count_around_eye(&caster, 0), cut);
        shaded += cut;
    }
    print_message("%d eyes in a shadow\n", shaded);
    assert_true(shaded > 100);
    end();
}

// A square plate of side a at the height h under a lamp at H throws a square of side a H / (H - h). The eye
// stands in the volumes of `around` more plates, whose shadows cover all that is seen. An outline is
// uncertain by half a pixel.
static void test_areas(void **unused) {
    (void)unused;
    const float lamp = 14, height = 4, side = 0.8f;
    for (int around = 0; around < 3; around++)
        for (int method = 1; method < 3; method++) {
            const int begins_with = (int)prediction_answer(LAB_ID, 2, (const double[4]){around, 0});
            Scene scene = closed_wall(6, 10, glm_rad(40));
            closed_add(&scene, SHAPE_BOX, vec3_make(1.8f, 0, height), vec3_make(side / 2, side / 2, 1e-4f),
                       0);
            for (int i = 0; i < around; i++)
                closed_add(&scene, SHAPE_BOX, vec3_make(0, 0, 11 + (float)i), vec3_make(4, 4, 0.01f), 0);
            closed_light(&scene, LIGHT_POINT, vec3_make(3, 0, lamp), vec3_make(0, 0, 0), 1, 0, 1, 20);
            const WitnessKnob knob = {"method", (float)method};
            Image image = witness_draw(LAB_ID, &scene, "stencil counts", SIZE, SIZE, &knob, 1);
            double unit = closed_unit(&scene, SIZE), area = 0, shadow = side * lamp / (lamp - height);
            for (int i = 0; i < SIZE * SIZE; i++)
                area += (image.rgba[4 * (size_t)i] + 32) / 64 == begins_with + 1 ? unit * unit : 0;
            print_message("%d around the eye, method %d: %.3f, expected %.3f\n", around, method, area,
                          shadow * shadow);
            assert_true(fabs(area - shadow * shadow) < 4 * shadow * unit / 2 + 0.01);
            image_destroy(&image);
        }
}

// A plate at the height h under a lamp at H: with less than the least stretch its volume ends above the wall
// and shades nothing, with more it shades what it should.
static void test_stretch(void **unused) {
    (void)unused;
    const double lamp = 9, height = 2, least = prediction_answer(LAB_ID, 0, (const double[4]){lamp, height});
    for (int i = -1; i <= 1; i += 2) {
        Scene scene = closed_wall(6, 10, glm_rad(40));
        closed_add(&scene, SHAPE_BOX, vec3_make(1, 0, (float)height), vec3_make(0.5f, 0.5f, 1e-4f), 0);
        closed_light(&scene, LIGHT_POINT, vec3_make(4, 0, (float)lamp), vec3_make(0, 0, 0), 1, 0, 1, 20);
        const WitnessKnob knobs[] = {{"method", 2}, {"stretch", (float)(least * (1 + 0.01 * i))}};
        Image image = witness_draw(LAB_ID, &scene, "stencil counts", SIZE, SIZE, knobs, 2);
        int shaded = 0;
        for (int p = 0; p < SIZE * SIZE; p++)
            shaded += image.rgba[4 * (size_t)p] > 32;
        print_message("stretch %.4f: %d pixels in shadow\n", least * (1 + 0.01 * i), shaded);
        assert_true(i < 0 ? shaded == 0 : shaded > 100);
        image_destroy(&image);
    }
}

int main(void) {
    (void)caster_create, (void)shell_destroy, (void)add_side, (void)add_caps;
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_silhouettes), cmocka_unit_test(test_rays),
                                       cmocka_unit_test(test_areas), cmocka_unit_test(test_stretch)};
    return cmocka_run_group_tests_name("witness " LAB_ID, tests, NULL, NULL);
}
