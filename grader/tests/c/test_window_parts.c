// What the window draws beside a lab's pictures, without GL: colours of counts, captions, lines of lights,
// enlarged pictures.
#include "base/files.h"
#include "scene/check.h"
#include "window/captions.h"
#include "window/counts.h"
#include "window/guide_lines.h"
#include "window/help.h"
#include "window/keys.h"
#include "window/place.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void test_counts(void **unused) {
    (void)unused;
    for (int i = 0; counts_color(i); i++)
        for (int k = 0; k < i; k++) {
            int away = 0;
            for (int c = 0; c < 3; c++)
                away += abs(counts_color(i)->shown[c] - counts_color(k)->shown[c]);
            assert_true(away > 60); // to be told apart
        }
    assert_string_equal(counts_find((const uint8_t[]){127, 128, 129})->name, "2"); // a driver may round
    assert_string_equal(counts_find((const uint8_t[]){255, 64, 0})->name, "-2");
    assert_null(counts_find((const uint8_t[]){255, 0, 255})); // no texture is there
    Image picture = {0};
    assert_true(image_create(&picture, 2, 1));
    memcpy(picture.rgba, (const uint8_t[]){64, 64, 64, 255, 9, 90, 200, 255}, 8);
    counts_recolor(&picture);
    assert_memory_equal(picture.rgba, counts_color(1)->shown, 3);
    assert_int_equal(picture.rgba[5], 90);
    image_destroy(&picture);
    counts_recolor(&picture); // none yet
}

static void test_captions(void **unused) {
    (void)unused;
    char folder[FILES_PATH], path[FILES_PATH];
    Captions captions;
    assert_true(files_make_temporary(folder));
    const Rubric rubric = {.folder = folder}, none = {0};
    assert_true(captions_load(&captions, &none) &&
                captions_load(&captions, &rubric)); // a lab need not have them
    assert_string_equal(captions_find(&captions, "map"), "");
    assert_string_not_equal(captions_find(&captions, "visibility"), "");
    files_join(path, folder, "captions.json");
    assert_true(files_write(path, "{\"map\": \"depth\"}") && captions_load(&captions, &rubric));
    assert_string_equal(captions_find(&captions, "map"), "depth");
    assert_string_equal(captions_find(&captions, "lens"), "");
    captions_destroy(&captions);
    const char *wrong[] = {"{\"map\": 3}", "[]", "{\"map\": \"\"}", "{\"map\": \"a\", \"map\": \"b\"}", "{"};
    for (int i = 0; i < 5; i++) {
        check_clear();
        assert_true(files_write(path, wrong[i]));
        assert_false(captions_load(&captions, &rubric));
        assert_non_null(strstr(check_message(), "captions.json"));
    }
    check_clear();
    files_remove(folder);
}

static bool has_end(const GuideLines *lines, float x, float y, float z) {
    for (int i = 0; i < lines->count; i++)
        if (glms_vec3_distance(lines->ends[i], vec3_make(x, y, z)) < 1e-3F)
            return true;
    return false;
}

// Corners by closed forms.
static void test_light_lines(void **unused) {
    (void)unused;
    GuideLines sun = {.count = 0}, spot = {.count = 0}, lamp = {.count = 0};
    Light light = {.kind = LIGHT_DIRECTIONAL,
                   .position = {{0, 10, 0}},
                   .target = {{0, 0, 0}},
                   .half_size = 3,
                   .near_plane = 2,
                   .far_plane = 12};
    guide_lines_add(&sun, &light); // straight above
    assert_int_equal(sun.count, 2 * (3 + 12));
    for (int i = 0; i < 8; i++)
        assert_true(has_end(&sun, i & 1 ? 3 : -3, i & 2 ? 8 : -2, i & 4 ? 3 : -3));
    light = (Light){.kind = LIGHT_SPOT,
                    .position = {{1, 2, 10}},
                    .target = {{1, 2, 0}},
                    .fov_y = glm_rad(90),
                    .extent = 0.5F,
                    .near_plane = 1,
                    .far_plane = 4};
    guide_lines_add(&spot, &light); // tan 45 degrees is 1
    assert_int_equal(spot.count, 2 * (3 + 12 + 4));
    for (int i = 0; i < 4; i++) {
        const float x = i & 1 ? 1 : -1, y = i & 2 ? 1 : -1;
        assert_true(has_end(&spot, 1 + x, 2 + y, 9) && has_end(&spot, 1 + 4 * x, 2 + 4 * y, 6));
        assert_true(has_end(&spot, 1 + x / 2, 2 + y / 2, 10));
    }
    light = (Light){.kind = LIGHT_POINT, .target = {{1, 0, 0}}, .near_plane = 0.1F, .far_plane = 2};
    guide_lines_add(&lamp, &light);
    assert_true(has_end(&lamp, 2, -2, 2) && has_end(&lamp, 0, 0, 0));
    for (int i = 0; i < 10; i++)
        guide_lines_add(&lamp, &light); // more than there is room for
    assert_true(lamp.count <= GUIDE_MOST_ENDS);
}

static void test_enlarged(void **unused) {
    (void)unused;
    Place place = place_enlarged(181, 133, 800, 600);
    assert_true(place.width == 724 && place.height == 532 && place.x == 38 && place.y == 34);
    place = place_enlarged(640, 500, 320, 200); // larger than the window
    assert_true(place.width <= 320 && place.height <= 200 && place.height == 200);
    place = place_enlarged(181, 133, 1, 1);
    assert_true(place.width <= 1 && place.height <= 1);
}

// Is each word of the table on one of the pages, and does each page fit?
static void assert_whole(int columns, int rows) {
    static char all[40000];
    static Lines lines;
    const char *keys, *meaning;
    int pages = 1;
    all[0] = '\0';
    for (int page = 1; page <= pages; page++) {
        lines_clear(&lines);
        lines.columns = columns;
        pages = help_page(&lines, rows, page);
        assert_true(lines.count > 0 && lines.count <= rows && (int)lines.longest <= columns);
        for (int i = 0; i < lines.count; i++)
            check_append(all, sizeof all, "%s ", lines.of[i]);
    }
    for (int row = 0; keys_help(row, &keys, &meaning); row++)
        for (const char *word = meaning; word; word = strchr(word + 1, ' ')) {
            char one[64] = "";
            snprintf(one, sizeof one, "%.*s", (int)strcspn(word + 1, " ") + 1, word);
            if (!strstr(all, keys) || !strstr(all, one))
                fail_msg("%d columns, %d rows, %d pages: \"%s\" of %s is missing", columns, rows, pages, one,
                         keys);
        }
}

// Whatever the size of the window, all keys are told.
static void test_help(void **unused) {
    (void)unused;
    for (int columns = 30; columns < 140; columns++)
        for (int rows = 8; rows < 40; rows++)
            assert_whole(columns, rows);
    static Lines lines;
    lines.columns = 100;
    assert_int_equal(help_page(&lines, 40, 1), 1); // the table has 31 rows
    lines_clear(&lines);
    assert_int_equal(help_page(&lines, 20, 2), 2);
    assert_string_equal(lines.of[lines.count - 1], "2 of 2: F1 closes this");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_counts), cmocka_unit_test(test_captions),
                                       cmocka_unit_test(test_light_lines), cmocka_unit_test(test_enlarged),
                                       cmocka_unit_test(test_help)};
    return cmocka_run_group_tests_name("window parts", tests, NULL, NULL);
}
