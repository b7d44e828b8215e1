// The window's parts without GL: orbits, knobs, pictures put together, places, states, watched files.
#include "window/compose.h"
#include "window/knob_step.h"
#include "window/orbit.h"
#include "window/place.h"
#include "window/view_state.h"
#include "base/file_watch.h"
#include "protocol/description.h"
#include "score/score.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static const vec3s up = {{0, 1, 0}};

static bool near(vec3s a, float x, float y, float z) {
    return glms_vec3_norm(glms_vec3_sub(a, vec3_make(x, y, z))) < 1e-5F;
}

static void test_camera(void **unused) {
    (void)unused;
    const Camera start = {.eye = {{1, 2, 5}}, .target = {{1, 2, 1}}};
    Camera camera = start;
    orbit_camera(&camera, &(Orbit){0});
    assert_memory_equal(&camera, &start, sizeof start); // untouched to the last bit
    orbit_camera(&camera, &(Orbit){.azimuth = glm_rad(90)});
    assert_true(near(camera.eye, 5, 2, 1) && near(camera.target, 1, 2, 1)); // from +z to +x
    camera = start;
    orbit_camera(&camera, &(Orbit){.elevation = glm_rad(30), .zoom = logf(2)});
    assert_true(near(camera.eye, 1, 2 + 8 * 0.5F, 1 + 8 * sqrtf(0.75F)));
    camera = start;
    orbit_camera(&camera, &(Orbit){.right = 0.5F, .up = -0.25F}); // of a distance of 4
    assert_true(near(camera.eye, 3, 1, 5) && near(camera.target, 3, 1, 1));
}

// Dragged far over the pole, the eye stops before it, and comes back with the first step back.
static void test_limits(void **unused) {
    (void)unused;
    const vec3s arm = {{0, 3, 4}};
    Orbit orbit = {.elevation = 50, .zoom = 99};
    orbit_limit(&orbit, arm);
    Camera camera = {.eye = arm};
    orbit_camera(&camera, &(Orbit){.elevation = orbit.elevation});
    float angle = acosf(glms_vec3_dot(glms_vec3_normalize(camera.eye), up));
    assert_true(angle > 0.01F && angle < 0.05F);
    assert_true(orbit.zoom < 3);
    orbit.elevation = -50;
    orbit_limit(&orbit, arm);
    camera.eye = arm;
    orbit_camera(&camera, &orbit);
    assert_true(camera.eye.y < 0 && isfinite(camera.eye.y));
    Orbit steep = {0}; // a light straight above may stay there
    orbit_limit(&steep, vec3_make(0, 10, 0));
    assert_true(fabsf(steep.elevation) < 1e-6F);
}

static void test_light(void **unused) {
    (void)unused;
    const Light start = {.position = {{0, 5, 0.001F}}, .target = {{0, 1, 0.001F}}};
    Light light = start;
    Orbit still = orbit_swing(&(Orbit){0}, 0);
    orbit_light(&light, &still);
    assert_memory_equal(&light, &start, sizeof start);
    light = (Light){.position = {{3, 0, 0}}};
    orbit_light(&light, &(Orbit){.azimuth = glm_rad(-90), .zoom = 5});
    assert_true(near(light.position, 0, 0, 3)); // as far as before
    Orbit quarter = orbit_swing(&(Orbit){.azimuth = 1}, 2), half = orbit_swing(&(Orbit){.azimuth = 1}, 4);
    assert_true(quarter.azimuth > 1.5F && quarter.azimuth < 1.8F);
    assert_true(fabsf(half.azimuth - 1) < 1e-5F);
}

static float stepped(const char *unit, float low, float high, float value, float from, int direction,
                     bool fine) {
    struct KnobText knob = {.low = low, .high = high, .value = value};
    snprintf(knob.unit, sizeof knob.unit, "%s", unit);
    return knob_step(&knob, from, direction, fine);
}

static void test_knobs(void **unused) {
    (void)unused;
    assert_true(stepped("texels", 64, 4096, 512, 512, 1, false) == 1024);
    assert_true(stepped("texels", 64, 4096, 512, 96, -1, false) == 64);
    assert_true(stepped("texels", 64, 4096, 512, 512, -1, true) == 511);
    assert_true(stepped("texels", 64, 4096, 512, 4096, 1, false) == 4096);
    assert_true(stepped("", 0, 200000, 4, 0, 1, false) == 1 && stepped("", 0, 200000, 4, 1, -1, false) == 0);
    assert_true(stepped("", 0, 8, 2, 2, 1, false) == 3 && stepped("", 0, 8, 2, 0, -1, false) == 0);
    assert_true(fabsf(stepped("", 0, 0.1F, 0.01F, 0.01F, 1, false) - 0.015F) < 1e-6F);
    assert_true(fabsf(stepped("", 0, 0.1F, 0.01F, 0.01F, -1, true) - 0.0095F) < 1e-6F);
    assert_true(fabsf(stepped("", 0.1F, 100, 100, 50, -1, false) - 50 / sqrtf(2)) < 1e-4F);
    assert_true(stepped("", 0, 0, 0, 0, 1, false) == 0); // untrusted: no range at all
}

static void test_knob_texts(void **unused) {
    (void)unused;
    char text[300];
    struct KnobText knob = {.high = 2, .choices = {"plain", "posterised", "normal"}, .choice_count = 3};
    knob_text(&knob, 1, text, sizeof text);
    assert_string_equal(text, "1: posterised  (plain, posterised, normal)");
    assert_string_equal(knob_choice(&knob, 3), ""); // a stranger's knob may go where nothing has a name
    assert_string_equal(knob_choice(&knob, -1), "");
    assert_string_equal(knob_choice(&knob, 1.6F), "normal");
    knob = (struct KnobText){.unit = "texels", .low = 16, .high = 2048};
    knob_text(&knob, 256, text, sizeof text);
    assert_string_equal(text, "256 texels  (16..2048)");
    knob = (struct KnobText){.unit = "KiB", .low = 0.5F, .high = 2000000};
    knob_text(&knob, 32768, text, sizeof text);
    assert_string_equal(text, "32768 KiB  (0.5..2000000)");
}

// A picture of one colour.
static Image plain(int width, int height, uint8_t grey) {
    Image image = {0};
    assert_true(image_create(&image, width, height));
    score_fill(&image, (uint8_t[3]){grey, grey, grey});
    return image;
}

static void set_pixel(Image *image, int x, int y, uint8_t r, uint8_t g, uint8_t b) {
    memcpy(image->rgba + image_at(image, x, y), (uint8_t[3]){r, g, b}, 3);
}

static void assert_pixel(const Image *image, int x, int y, uint8_t r, uint8_t g, uint8_t b) {
    assert_memory_equal(image->rgba + image_at(image, x, y), ((uint8_t[3]){r, g, b}), 3);
}

static void test_split(void **unused) {
    (void)unused;
    Image mine = plain(10, 2, 10), other = plain(10, 2, 200), out = {0};
    compose(&out, SHOW_SPLIT, &mine, &other, 0.3F);
    assert_pixel(&out, 2, 1, 10, 10, 10);
    assert_pixel(&out, 3, 1, 200, 200, 200);
    compose(&out, SHOW_SPLIT, &mine, &other, 7); // a split beyond the picture
    assert_pixel(&out, 9, 0, 10, 10, 10);
    compose(&out, SHOW_REFERENCE, &mine, &other, 0.3F);
    assert_pixel(&out, 0, 0, 200, 200, 200);
    compose(&out, SHOW_MINE, &mine, &other, 0.3F);
    assert_pixel(&out, 9, 0, 10, 10, 10);
    Image none = {0};
    compose(&out, SHOW_SPLIT, &none, &other, 0.5F); // nothing of mine yet
    assert_pixel(&out, 0, 0, 40, 40, 40);
    assert_pixel(&out, 5, 0, 200, 200, 200);
    Image small = plain(5, 5, 1); // mine of another size, before the window was resized
    compose(&out, SHOW_DIFFERENCE, &small, &other, 0.5F);
    assert_true(out.width == 10 && out.height == 2);
    compose(&out, SHOW_TRUTH, &none, &none, 0.5F);
    assert_true(out.width == 10);
    Image *all[] = {&mine, &other, &out, &small};
    for (int i = 0; i < 4; i++)
        image_destroy(all[i]);
}

static void test_difference(void **unused) {
    (void)unused;
    Image mine = plain(4, 1, 100), other = plain(4, 1, 100), out = {0};
    set_pixel(&mine, 0, 0, 160, 160, 160); // lit where the reference has a shadow: false light
    set_pixel(&mine, 1, 0, 40, 40, 40);    // false shadow
    set_pixel(&mine, 2, 0, 120, 100, 80);  // as bright, another colour
    set_pixel(&mine, 3, 0, 102, 102, 102); // within the tolerance
    Difference found = compose(&out, SHOW_DIFFERENCE, &mine, &other, 0.5F);
    assert_true(found.brighter == 1 && found.darker == 1 && found.other == 1);
    const uint8_t *yellow = out.rgba, *blue = out.rgba + 4, *grey = out.rgba + 12;
    assert_true(yellow[0] > 200 && yellow[1] > 150 && yellow[2] < 80);
    assert_true(blue[2] > 200 && blue[0] < 80);
    assert_true(grey[0] == grey[1] && grey[1] == grey[2] && grey[0] < 128);
    Image *all[] = {&mine, &other, &out};
    for (int i = 0; i < 3; i++)
        image_destroy(all[i]);
}

static void assert_place(Place place, int x, int y, int width, int height) {
    assert_true(place.x == x && place.y == y && place.width == width && place.height == height);
}

static void test_places(void **unused) {
    (void)unused;
    assert_place(place_picture(800, 600, 800, 600, 1), 0, 0, 800, 600);
    assert_place(place_picture(267, 200, 801, 601, 3), 0, 0, 801, 600);    // a row is left over
    assert_place(place_picture(400, 300, 1000, 600, 1), 100, 0, 800, 600); // an old one, stretched
    assert_place(place_picture(400, 300, 400, 900, 1), 0, 300, 400, 300);
}

static void test_state(void **unused) {
    (void)unused;
    const Rubric none = {0};
    Rubric rubric = {
        .check_count = 2,
        .checks = {{.view = "picture", .scene = "table sun", .scenes = {"table sun"}, .scene_count = 1},
                   {.view = "visibility",
                    .scene = "wide floor",
                    .scenes = {"wide floor"},
                    .scene_count = 1,
                    .knobs = {{.name = "map size", .value = 64}},
                    .knob_count = 1}}};
    ViewState state;
    Request request, again;
    Scene scene;
    view_state_begin(&state, &rubric);
    assert_true(view_state_request(&state, 40, 30, &request) && view_state_request(&state, 40, 30, &again));
    assert_memory_equal(&request, &again, sizeof request);
    memset(&scene, 0, sizeof scene);
    assert_true(scene_make(&scene, "table sun", &(Random){1}));
    assert_memory_equal(&request.scene, &scene, sizeof scene);
    view_state_step_check(&state, &rubric, -1);
    assert_true(view_state_request(&state, 40, 30, &request));
    assert_string_equal(request.view, "visibility");
    assert_true(request.knob_count == 1 && request.knobs[0].value == 64);
    view_state_step_scene(&state, &rubric, 1);
    assert_string_equal(state.scene, "table sun");
    state.show = SHOW_DIFFERENCE;
    assert_true(view_state_needs_mine(&state) && view_state_needs_reference(&state) &&
                !view_state_needs_truth(&state));
    state.against_truth = true;
    view_state_step_view(&state, &(Description){.stage_count = 1, .stages = {"map"}}, 1);
    assert_string_equal(state.view, "map");
    assert_true(view_state_request(&state, 40, 30, &request));
    assert_string_equal(request.view, "visibility"); // the truth knows nothing else
    view_state_begin(&state, &none);
    assert_true(view_state_request(&state, 40, 30, &request)); // without a rubric
    snprintf(state.scene, sizeof state.scene, "nowhere");
    assert_false(view_state_request(&state, 40, 30, &request));
}

// A check is named only as long as everything is as it asks.
static void test_label(void **unused) {
    (void)unused;
    const Rubric rubric = {.check_count = 1,
                           .checks = {{.name = "far",
                                       .task = "3.8",
                                       .view = "visibility",
                                       .scene = "far floor",
                                       .knobs = {{.name = "map size", .value = 64}},
                                       .knob_count = 1}}};
    char text[300];
    ViewState state;
    view_state_begin(&state, &rubric);
    view_state_step_check(&state, &rubric, 1);
    view_state_text(&state, &rubric, text, sizeof text);
    assert_string_equal(text, "visibility of \"far floor\", seed 1  [check 3.8: far]");
    view_state_set_knob(&state, "map size", 128);
    view_state_text(&state, &rubric, text, sizeof text);
    assert_string_equal(text, "visibility of \"far floor\", seed 1");
}

static void write_file(const char *folder, const char *name, const char *text) {
    char path[FILES_PATH];
    files_join(path, folder, name);
    assert_true(files_write(path, text));
}

static void test_watch(void **unused) {
    (void)unused;
    static FileWatch watch;
    char folder[FILES_PATH], from[FILES_PATH], to[FILES_PATH];
    assert_true(files_make_temporary(folder));
    write_file(folder, "a.frag", "one");
    file_watch_begin(&watch, folder, "");
    assert_false(file_watch_found(&watch));
    write_file(folder, "notes.txt", "nobody draws this");
    assert_false(file_watch_found(&watch) || file_watch_found(&watch));
    write_file(folder, "a.frag", "three");
    assert_false(file_watch_found(&watch)); // perhaps not written to its end
    assert_true(file_watch_found(&watch));
    assert_false(file_watch_found(&watch));
    write_file(folder, "b", "as long"); // renamed over, as some editors save
    files_join(from, folder, "b");
    files_join(to, folder, "a.frag");
    assert_int_equal(rename(from, to), 0);
    assert_false(file_watch_found(&watch));
    assert_true(file_watch_found(&watch));
    files_remove(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_camera),     cmocka_unit_test(test_limits),     cmocka_unit_test(test_light),
        cmocka_unit_test(test_knobs),      cmocka_unit_test(test_knob_texts), cmocka_unit_test(test_split),
        cmocka_unit_test(test_difference), cmocka_unit_test(test_places),     cmocka_unit_test(test_state),
        cmocka_unit_test(test_label),      cmocka_unit_test(test_watch)};
    return cmocka_run_group_tests_name("view", tests, NULL, NULL);
}
