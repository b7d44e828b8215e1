// What a frame costs, against counts by hand: of pictures that tell where a shader reads how often.
#include "base/places.h"
#include "compile/lab_folder.h"
#include "compile/rubric_file.h"
#include "exam/worker_client.h"
#include "scene/check.h"
#include "truth/closed_scenes.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { WIDTH = 160, HEIGHT = 120, MAP = 256, SEARCH = 5, FILTER = 3 };

static Rubric rubric;

// A wall that fills the picture, and a lamp from aside. Planes are not in the map.
static Scene wall(void) {
    Scene scene = closed_wall(3, 10, glm_rad(16));
    closed_light(&scene, LIGHT_SPOT, vec3_make(6, 0, 8), vec3_make(0, 0, 0), glm_rad(30), 0, 2, 20);
    scene.lights[0].extent = 0.5F;
    return scene;
}

// A box that throws its shadow into the picture and is not in it itself: each pixel is shaded once.
static void add_box(Scene *scene) {
    closed_add(scene, SHAPE_BOX, vec3_make(2.4F, 0.1F, 3.2F), vec3_make(0.3F, 0.3F, 0.3F), 20);
}

static Request request_of(const Scene *scene, const char *view, int counted) {
    Request request = {.magic = PROTOCOL_MAGIC,
                       .width = WIDTH,
                       .height = HEIGHT,
                       .fresh = 1,
                       .counted = counted,
                       .knobs = {{"map size", MAP}, {"search taps", SEARCH}, {"filter taps", FILTER}},
                       .knob_count = 3,
                       .scene = *scene};
    snprintf(request.view, sizeof request.view, "%s", view);
    return request;
}

// By lab 14 with this change, in a worker of its own.
static DrawResult draw_changed(const Change *change, const Scene *scene, const char *view, int counted,
                               Image *image, Reply *reply) {
    static Request request;
    WorkerClient client = {.trust = TRUST_OURS, .quick_shaders = true};
    assert_true(lab_folder_ours(client.folder, &rubric, (Solved){SOLVED_ALL, NULL}, change));
    request = request_of(scene, view, counted);
    const DrawResult result = worker_client_draw(&client, &request, image, reply);
    worker_client_stop(&client);
    return result;
}

static Image draw(const Scene *scene, const char *view, int counted, Reply *reply) {
    Image image = {0};
    if (draw_changed(NULL, scene, view, counted, &image, reply) != DRAW_OK || reply->message[0])
        fail_msg("%s: %s", view, reply->message);
    return image;
}

static int pixels_with(const Image *image, int channel, int least) {
    int count = 0;
    for (int i = 0; i < image->width * image->height; i++)
        count += image->rgba[4 * i + channel] >= least;
    return count;
}

// Nothing is in the map, so that only the search reads, everywhere in the map.
static void test_search(void **unused) {
    (void)unused;
    static Reply reply;
    const Scene scene = wall();
    Image in_map = draw(&scene, "distances", COUNTED_NOT, &reply),
          lit = draw(&scene, "visibility", COUNTED_READS, &reply);
    assert_int_equal(reply.counts.counted, COUNTED_READS);
    assert_string_equal(reply.counts.uncounted, "");
    assert_true(reply.counts.fragments == WIDTH * HEIGHT);
    assert_true(reply.counts.texels == MAP * MAP);
    const int inside = pixels_with(&in_map, 0, 1);
    print_message("%d of %d pixels in the map\n", inside, WIDTH * HEIGHT);
    assert_true(inside > WIDTH * HEIGHT / 2 && reply.counts.taps == inside * SEARCH * SEARCH);
    image_destroy(&in_map);
    image_destroy(&lit);
}

// The stage "blockers" is not black where the search found something: there the filter reads, too.
static void test_filter(void **unused) {
    (void)unused;
    static Reply reply;
    Scene scene = wall();
    Image in_map = draw(&scene, "distances", COUNTED_NOT, &reply);
    add_box(&scene);
    Image found = draw(&scene, "blockers", COUNTED_NOT, &reply),
          plain = draw(&scene, "visibility", COUNTED_NOT, &reply),
          lit = draw(&scene, "visibility", COUNTED_READS, &reply);
    const int searched = pixels_with(&in_map, 0, 1), filtered = pixels_with(&found, 0, 1);
    print_message("%d pixels with a blocker\n", filtered);
    assert_true(filtered > 500 && filtered < searched);
    assert_true(reply.counts.taps == searched * SEARCH * SEARCH + filtered * FILTER * FILTER);
    assert_memory_equal(plain.rgba, lit.rgba, image_bytes(&plain)); // counting changes no pixel
    Image blind = draw(&scene, "visibility", COUNTED_BLIND, &reply);
    assert_int_equal(pixels_with(&blind, 0, 255), WIDTH * HEIGHT); // without a map there is no shadow
    assert_true(pixels_with(&lit, 0, 255) < WIDTH * HEIGHT);
    for (Image *image[] = {&in_map, &found, &plain, &lit, &blind}, **i = image; i < image + 5; i++)
        image_destroy(*i);
}

static const char READ[] = "lit += texture(u_shadow_map, place).r < position_map.z ? 0.0 : 1.0;";

// Each way to name a read counts, or is refused; none reads for nothing.
static void test_names(void **unused) {
    (void)unused;
    static const struct {
        const char *read;
        double taps; // of one turn of the filter; 0: refused
    } ways[] = {
        {"lit += texelFetch(u_shadow_map, ivec2(place * 256.0), 0).r < position_map.z ? 0.0 : 1.0;", 1},
        {"vec4 z = textureGather(u_shadow_map, place); lit += z.x < position_map.z ? 0.0 : 1.0;", 1},
        {"vec4 z = textureGather(u_shadow_map, place, 0); lit += z.x < position_map.z ? 0.0 : 1.0;", 1},
        {"lit += textureOffset(u_shadow_map, place, ivec2(1, 0)).r < position_map.z ? 0.0 : 1.0;", 1},
        {"lit += textureLod(u_shadow_map, place, 0.0).r + texture(u_shadow_map, place).r;", 2},
        {"\n#define ANY texture\nlit += ANY(u_shadow_map, place).r;\n", 1},
        {"\n#define ANY tex##ture\nlit += ANY(u_shadow_map, place).r;\n", 0},
        {"\n#undef texture\nlit += texture(u_shadow_map, place).r;\n", 0},
        {"\n#un\\\ndef texture\nlit += texture(u_shadow_map, place).r;\n", 0},
        {"lit += textureProjLod(u_shadow_map, vec3(place, 1.0), 0.0).r;", 1},
        {"lit += textureProjLod(u_shadow_map, vec4(place, 0.0, 1.0), 0.0).r;", 0},
        {"lit += texture(u_shadow_map, place).r; atomicCounterDecrement(counted_taps);", 0},
    };
    static Reply reply;
    Scene scene = wall();
    add_box(&scene);
    Image found = draw(&scene, "blockers", COUNTED_NOT, &reply), image = {0};
    const int filtered = pixels_with(&found, 0, 1);
    draw_changed(NULL, &scene, "visibility", COUNTED_READS, &image, &reply);
    const double search = reply.counts.taps - filtered * FILTER * FILTER;
    for (unsigned i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        const Edit edit = {"pcss.glsl", READ, ways[i].read};
        const Change change = {.name = "a way to read", .edits = {edit}, .edit_count = 1};
        const bool drawn =
            draw_changed(&change, &scene, "visibility", COUNTED_READS, &image, &reply) == DRAW_OK;
        if (drawn != (ways[i].taps > 0) ||
            (drawn && reply.counts.taps != search + filtered * FILTER * FILTER * ways[i].taps))
            fail_msg("%s: drawn %d, %.0f taps: %s %s", ways[i].read, drawn, reply.counts.taps,
                     reply.counts.uncounted, reply.message);
    }
    image_destroy(&image);
    image_destroy(&found);
}

// Five methods, counted by hand: where the search found anything, and where not all that it met is a blocker,
// a stage shows.
static void test_methods(void **unused) {
    (void)unused;
    static const Edit twice = {"pcss.glsl", "float depth = texture(u_shadow_map, place).r;",
                               "float depth = 0.5 * (texture(u_shadow_map, place).r + "
                               "texelFetch(u_shadow_map, ivec2(place * 256.0), 0).r);"},
                      fewer = {"pcss.glsl", "for (int j = 0; j < u_filter_taps; j++)",
                               "for (int j = 1; j < u_filter_taps; j++)"},
                      fixed = {"shadow.frag", "if (!u_fixed)", "if (u_fixed)"},
                      core = {"pcss.glsl", "return found > 0 ?",
                              "if (found == u_search_taps * u_search_taps) return -1.0;\nreturn found > 0 ?"},
                      exits = {"shadow.frag", "if (blocker == 0.0)\n            return 1.0;",
                               "if (blocker <= 0.0) return blocker < 0.0 ? 0.0 : 1.0;"};
    const Change stops = {.name = "stops in the core", .edits = {core, exits}, .edit_count = 2};
    static Reply reply;
    Scene scene = wall();
    Image in_map = draw(&scene, "distances", COUNTED_NOT, &reply), partly = {0}, image = {0};
    add_box(&scene);
    Image found = draw(&scene, "blockers", COUNTED_NOT, &reply);
    assert_int_equal(draw_changed(&stops, &scene, "blockers", COUNTED_NOT, &partly, &reply), DRAW_OK);
    const double searched = pixels_with(&in_map, 0, 1), filtered = pixels_with(&found, 0, 1),
                 unsure = pixels_with(&partly, 0, 1), search = SEARCH * SEARCH, filter = FILTER * FILTER;
    assert_true(unsure > 100 && unsure < filtered - 100);
    const struct {
        Change change;
        double taps;
    } methods[] = {
        {{.name = "a search of twice the reads", .edits = {twice}, .edit_count = 1},
         2 * search * searched + filter * filtered},
        {{.name = "as it is", .edit_count = 0}, search * searched + filter * filtered},
        {{.name = "a filter without a row", .edits = {fewer}, .edit_count = 1},
         search * searched + (filter - FILTER) * filtered},
        {stops, search * searched + filter * unsure},
        {{.name = "one kernel for all", .edits = {fixed}, .edit_count = 1}, filter * searched},
    };
    for (unsigned i = 0; i < sizeof methods / sizeof methods[0]; i++) {
        assert_int_equal(
            draw_changed(&methods[i].change, &scene, "visibility", COUNTED_READS, &image, &reply), DRAW_OK);
        print_message("%s: %.0f\n", methods[i].change.name, reply.counts.taps);
        if (reply.counts.taps != methods[i].taps)
            fail_msg("by hand: %.0f", methods[i].taps);
    }
    for (Image *images[] = {&in_map, &found, &partly, &image}, **i = images; i < images + 4; i++)
        image_destroy(*i);
}

// By the solution of another lab.
static void draw_other(const char *id, const Request *request, Image *image, Reply *reply) {
    char place[FILES_PATH];
    Rubric other;
    WorkerClient client = {.trust = TRUST_OURS, .quick_shaders = true};
    assert_true(places_find_lab(place, id) && rubric_load(&other, place));
    assert_true(lab_folder_ours(client.folder, &other, (Solved){SOLVED_ALL, NULL}, NULL));
    if (worker_client_draw(&client, request, image, reply) != DRAW_OK)
        fail_msg("lab %s, counted %d: %s", id, request->counted, reply->message);
    worker_client_stop(&client);
    rubric_destroy(&other);
}

// Every lab of ours can be counted, and counting changes no pixel but where an offset is rounded otherwise.
static void compare(const char *id, void *unused) {
    (void)unused;
    static Reply reply;
    static Request request;
    Image images[2] = {{0}};
    Scene scene = wall();
    closed_add(&scene, SHAPE_BOX, vec3_make(0.5F, 0.1F, 0.6F), vec3_make(0.3F, 0.3F, 0.3F), 20);
    for (int counted = 0; counted < 2; counted++) {
        request = request_of(&scene, "visibility", counted);
        request.knob_count = 0;
        draw_other(id, &request, &images[counted], &reply);
    }
    long differ = 0;
    for (size_t at = 0; at < image_bytes(&images[0]); at++)
        differ += abs(images[0].rgba[at] - images[1].rgba[at]) > 2;
    print_message("lab %s: %.0f reads, %.0f fragments, %.0f texels; %ld bytes differ\n", id,
                  reply.counts.taps, reply.counts.fragments, reply.counts.texels, differ);
    assert_true(reply.counts.fragments >= WIDTH * HEIGHT && differ <= 8);
    image_destroy(&images[0]);
    image_destroy(&images[1]);
}

static void test_all_labs(void **unused) {
    (void)unused;
    assert_true(places_list_labs(compare, NULL));
}

// Of a texture with layers a clear writes the one that is attached: n x n lamps of lab 11 have as many maps.
static void test_layers(void **unused) {
    (void)unused;
    enum { LAMPS = 3, SIDE = 128 };
    static Reply reply;
    Image image = {0};
    const Scene scene = wall();
    Request request = request_of(&scene, "visibility", COUNTED_READS);
    request.knobs[0].value = SIDE;
    request.knobs[1] = (KnobSetting){"lamps", LAMPS};
    request.knob_count = 2;
    draw_other("11", &request, &image, &reply);
    assert_true(reply.counts.texels == LAMPS * LAMPS * SIDE * SIDE);
    image_destroy(&image);
}

// Texels that come from the processor, and what is copied, are told.
static void test_past_counters(void **unused) {
    (void)unused;
    static const char *const calls[] = {
        "static const float z = 1; glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 1, 1, 0, GL_RED, GL_FLOAT, &z);",
        "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 4, 4, 0);", "glGenerateMipmap(GL_TEXTURE_2D);"};
    static Reply reply;
    const Scene scene = wall();
    Image image = {0};
    for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++) {
        char after[400];
        snprintf(after, sizeof after,
                 "    frame_bind(frame);\n    glBindTexture(GL_TEXTURE_2D, state.shown[0].color);\n    %s\n",
                 calls[i]);
        const Edit edit = {"lab.c", "    frame_bind(frame);\n", after};
        const Change change = {.name = "past the counters", .edits = {edit}, .edit_count = 1};
        draw_changed(&change, &scene, "visibility", COUNTED_READS, &image, &reply);
        const size_t length = strcspn(strstr(calls[i], "gl"), "(");
        if (strncmp(reply.counts.uncounted, strstr(calls[i], "gl"), length) != 0)
            fail_msg("%s: \"%s\" %s", calls[i], reply.counts.uncounted, reply.message);
    }
    image_destroy(&image);
}

int main(void) {
    char folder[FILES_PATH];
    if (!places_find_lab(folder, "14") || !rubric_load(&rubric, folder)) {
        fprintf(stderr, "%s\n", check_message());
        return 1;
    }
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_search),       cmocka_unit_test(test_filter),
                                       cmocka_unit_test(test_names),        cmocka_unit_test(test_methods),
                                       cmocka_unit_test(test_all_labs),     cmocka_unit_test(test_layers),
                                       cmocka_unit_test(test_past_counters)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    rubric_destroy(&rubric);
    return failed;
}
