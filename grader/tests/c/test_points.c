// The error of a student's method beside recorded points, by hand; and what is said of a table of them.
#include "base/places.h"
#include "points/own_points.h"
#include "points/own_table.h"
#include "scene/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static void test_errors(void **unused) {
    (void)unused;
    Image truth = {0}, frame = {0};
    assert_true(image_create(&truth, 4, 1) && image_create(&frame, 4, 1));
    const uint8_t right[16] = {255, 255, 255, 255, 0, 0, 255, 255, 128, 128, 255, 255, 255, 255, 0, 255},
                  drawn[16] = {255, 255, 255, 255, 51, 51, 51, 255, 0, 0, 0, 0, 0, 0, 0, 255};
    memcpy(truth.rgba, right, sizeof right);
    memcpy(frame.rgba, drawn, sizeof drawn);
    // 0, 51 / 255, wholly wrong for no finite colour, and one that does not count.
    assert_true(fabs(own_points_error(&frame, &truth) - (0 + 0.2 + 1) / 3) < 1e-6);
    memset(truth.rgba, 0, 16);
    assert_true(own_points_error(&frame, &truth) == 0); // nothing counts
    image_destroy(&truth);
    image_destroy(&frame);
}

static char folder[FILES_PATH];

static bool read_table(OwnTable *table, const char *text) {
    char path[FILES_PATH];
    files_join(path, folder, "study-05.csv");
    assert_true(files_write(path, text));
    check_clear();
    return own_table_read(table, path);
}

#define HEADS "scene,title,method,setting,whose,ms,error,message\n"
#define TWO(title, method, our_ms, our_error, ms, error, message)                                            \
    "s," title "," method ",\"3 x 3, 9\",recorded," our_ms "," our_error ",\n"                               \
    "s," title "," method ",\"3 x 3, 9\",yours," ms "," error ",\"" message "\"\n"

// The least error is named, of two the faster one; and of ours what takes at most half of that time.
static void test_table(void **unused) {
    (void)unused;
    OwnTable table;
    assert_true(read_table(
        &table, HEADS TWO("A", "a", "1", "0.5", "1.5", "0.5", "")                                   //
        TWO("A", "b", "2", "0.25", "2.5", "0.25", "") TWO("A", "c", "9", "0.1", "8", "0.1", "")     //
        TWO("A", "d", "3", "0.1", "4.5", "0.1", "") TWO("A", "e", "1", "0", "0", "0", "it crashed") //
        TWO("B", "a", "1", "0.5", "1", "0.75", "")));
    assert_int_equal(table.count, 5); // what did not draw says nothing
    assert_int_equal(own_table_next_scene(&table, 0), 4);
    assert_int_equal(own_table_next_scene(&table, 4), 5);
    assert_string_equal(table.rows[own_table_best(&table, 0)].method, "d");
    assert_string_equal(table.rows[own_table_quicker(&table, 0, own_table_best(&table, 0))].method, "b");
    assert_int_equal(own_table_best(&table, 4), 4);
    assert_int_equal(own_table_quicker(&table, 4, 4), -1);
    assert_string_equal(table.rows[4].setting, "3 x 3, 9");
    assert_true(table.rows[4].error == 0.75 && table.rows[4].our_error == 0.5);
    own_table_destroy(&table);
}

static void test_damaged_tables(void **unused) {
    (void)unused;
    static const char *const empty[] = {
        HEADS,
        HEADS TWO("A", "a", "1", "0.5", "nan", "0.5", ""),
        HEADS TWO("A", "a", "1", "0.5", "-1", "0.5", ""),
        HEADS TWO("A", "a", "1", "x", "1", "0.5", ""),
        HEADS "s,A,a,b,yours,1,0.5,\ns,A,a,c,recorded,1,0.5,\n",
        HEADS "s,A,a,b,recorded,1,0.5,\ns,A,a,c,yours,1,0.5,\n",
    };
    OwnTable table;
    for (size_t i = 0; i < sizeof empty / sizeof *empty; i++) {
        assert_true(read_table(&table, empty[i]));
        assert_int_equal(table.count, 0);
        own_table_destroy(&table);
    }
    assert_false(read_table(&table, "scene,lab,whose\ns,05,ours\n"));
    assert_non_null(strstr(check_message(), "measure again"));
    assert_false(own_table_read(&table, "/no/such/file"));
    own_table_destroy(&table);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_errors), cmocka_unit_test(test_table),
                                       cmocka_unit_test(test_damaged_tables)};
    if (!files_make_temporary(folder))
        return 1;
    const int failed = cmocka_run_group_tests_name("points", tests, NULL, NULL);
    files_remove(folder);
    return failed;
}
