// The file of a student's progress: kept, whole, and never lost.
#include "scene/check.h"
#include "scene/count.h"
#include "base/files.h"
#include "grade/progress.h"

#include <jansson.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[FILES_PATH], file[FILES_PATH];

static int begin(void **unused) {
    (void)unused;
    check_clear();
    assert_true(files_make_temporary(folder));
    files_join(file, folder, "progress.json");
    return setenv("SHADOW_LAB_PROGRESS", file, 1);
}

static int end(void **unused) {
    (void)unused;
    files_remove(folder);
    return 0;
}

static Progress load(void) {
    static Progress progress;
    assert_true(progress_load(&progress));
    return progress;
}

static void test_nothing_yet(void **unused) {
    (void)unused;
    Progress progress = load();
    assert_int_equal(progress.count, 0);
    assert_string_equal(progress.note, "");
    assert_null(progress_find(&progress, "03"));
    assert_false(files_exists(file)); // looking changes nothing
}

static void test_kept(void **unused) {
    (void)unused;
    Progress progress = load();
    assert_true(progress_record(&progress, "03", 100, 100, true, NULL));
    assert_true(progress_record(&progress, "05", 12.34, 100, false, NULL));
    assert_true(progress_record(&progress, "03", 40, 100, false, NULL));
    Progress again = load();
    assert_int_equal(again.count, 2);
    const LabProgress *three = progress_find(&again, "03"), *five = progress_find(&again, "05");
    assert_true(three->score == 40 && three->best == 100 && !three->done);
    assert_int_equal(strlen(three->done_on), 10); // the day stays, also when it is broken again
    assert_true(five->score == 12.34 && five->best == 12.34 && five->done_on[0] == '\0');
}

static void test_unknown_keys_stay(void **unused) {
    (void)unused;
    Progress progress = load();
    assert_true(files_write(file, "{\"version\": 1, \"name\": \"me\", \"labs\": {}}"));
    assert_true(progress_record(&progress, "01", 1, 100, false, NULL));
    char *text = files_read(file, 1 << 16);
    assert_non_null(strstr(text, "\"me\""));
    free(text);
}

static json_t *entry_of(const char *id) {
    json_t *root = json_load_file(file, 0, NULL), *entry = NULL;
    assert_non_null(root);
    entry = json_incref(json_object_get(json_object_get(root, "labs"), id));
    json_decref(root);
    return entry;
}

static void test_mistakes(void **unused) {
    (void)unused;
    Progress progress = load();
    Change changes[3] = {{.name = "no bias"}, {.name = "no bias at all"}, {.name = "too much"}};
    const Rubric rubric = {.mistakes = changes, .mistake_count = 3};
    MistakesMet met = {0};
    mistakes_met_add(&met, &rubric, "too much, or no bias");
    mistakes_met_add(&met, &rubric, "no bias at all");
    mistakes_met_add(&met, &rubric, "too much"); // once is enough
    mistakes_met_add(&met, &rubric, "no bias whatever");
    mistakes_met_add(&met, &rubric, "");
    assert_int_equal(met.count, 2);
    assert_true(progress_record(&progress, "04", 1, 100, false, &met));
    assert_true(progress_record(&progress, "04", 1, 100, false, &met));
    json_t *entry = entry_of("04"), *mistakes = json_object_get(entry, "mistakes");
    assert_int_equal(json_array_size(mistakes), 2);
    assert_string_equal(json_string_value(json_array_get(mistakes, 0)), "too much");
    assert_string_equal(json_string_value(json_array_get(mistakes, 1)), "no bias at all");
    json_decref(entry);
}

// The seconds that are noted after a grading whose forerunner was so many seconds ago.
static double seconds_after(double ago) {
    char text[300];
    Progress progress = load();
    snprintf(text, sizeof text,
             "{\"version\": 1, \"labs\": {\"03\": {\"score\": 1, \"max_score\": 100, \"best\": 1, \"done\": "
             "false, "
             "\"mistakes\": 7, \"seconds\": 100, \"last\": %.0f}}}",
             (double)time(NULL) - ago);
    assert_true(files_write(file, text));
    assert_true(progress_record(&progress, "03", 2, 100, false, NULL));
    json_t *entry = entry_of("03");
    const double seconds = json_number_value(json_object_get(entry, "seconds"));
    json_decref(entry);
    return seconds;
}

// A pause of ten minutes is work, one of two hours is none, and a clock that was put back takes nothing away.
static void test_time(void **unused) {
    (void)unused;
    assert_true(seconds_after(600) >= 700 && seconds_after(600) < 1900);
    assert_true(seconds_after(7200) == 100);
    assert_true(seconds_after(-7200) == 100);
}

// Each damaged file is kept under a name of its own.
static void test_damaged(void **unused) {
    (void)unused;
    static const char *const damaged[] = {"",
                                          "{\"version\": 1, \"labs\": {\"03\": {\"sco",
                                          "[]",
                                          "{\"version\": 2, \"labs\": {}}",
                                          "{\"version\": 1, \"labs\": {\"03\": {\"score\": \"much\"}}}",
                                          "{\"version\": 1, \"labs\": {\"nine\": {}}}"};
    enum { DAMAGED = COUNT(damaged) };
    for (int i = 0; i < DAMAGED; i++) {
        char aside[FILES_PATH];
        snprintf(aside, sizeof aside, "%.4000s.damaged-%d", file, i + 1);
        assert_true(files_write(file, damaged[i]));
        Progress progress = load();
        assert_int_equal(progress.count, 0);
        assert_non_null(strstr(progress.note, aside));
        char *text = files_read(aside, 1 << 16);
        assert_string_equal(text, damaged[i]);
        free(text);
        assert_true(progress_record(&progress, "03", 7, 100, false, NULL));
        progress = load();
        assert_int_equal(progress.count, 1);
    }
}

// What cannot be replaced stays as it was, and says so.
static void test_not_writable(void **unused) {
    (void)unused;
    Progress progress = load();
    setenv("SHADOW_LAB_PROGRESS", "/no/such/folder/progress.json", 1);
    assert_false(progress_record(&progress, "03", 7, 100, false, NULL));
    assert_non_null(strstr(check_message(), "/no/such/folder/progress.json cannot be written"));
    check_clear();
    setenv("SHADOW_LAB_PROGRESS", folder, 1);
    assert_false(progress_load(&progress));
    assert_non_null(strstr(check_message(), "is not a regular file"));
}

// Several programs that record at once lose nothing.
static void test_at_once(void **unused) {
    (void)unused;
    enum { PROGRAMS = 4, TIMES = 25 };
    pid_t pids[PROGRAMS];
    for (int p = 0; p < PROGRAMS; p++) {
        pids[p] = fork();
        if (pids[p] == 0) {
            const char id[3] = {'0', (char)('1' + p), '\0'};
            static Progress progress;
            bool ok = true;
            for (int i = 1; i <= TIMES; i++)
                ok = progress_record(&progress, id, i, 100, false, NULL) && ok;
            _exit(ok && !progress.note[0] ? 0 : 1);
        }
    }
    for (int p = 0; p < PROGRAMS; p++) {
        int status;
        assert_int_equal(waitpid(pids[p], &status, 0), pids[p]);
        assert_int_equal(status, 0);
    }
    Progress progress = load();
    assert_int_equal(progress.count, PROGRAMS);
    for (int p = 0; p < PROGRAMS; p++)
        assert_true(progress.labs[p].score == TIMES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_nothing_yet, begin, end),
        cmocka_unit_test_setup_teardown(test_kept, begin, end),
        cmocka_unit_test_setup_teardown(test_unknown_keys_stay, begin, end),
        cmocka_unit_test_setup_teardown(test_mistakes, begin, end),
        cmocka_unit_test_setup_teardown(test_time, begin, end),
        cmocka_unit_test_setup_teardown(test_damaged, begin, end),
        cmocka_unit_test_setup_teardown(test_not_writable, begin, end),
        cmocka_unit_test_setup_teardown(test_at_once, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
