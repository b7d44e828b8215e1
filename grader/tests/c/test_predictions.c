// What predictions are worth, whatever the file is; and the questions and solutions of all labs are whole.
#include "base/places.h"
#include "compile/rubric_file.h"
#include "predict/prediction_sheet.h"
#include "predict/predictions.h"
#include "scene/check.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { SHEETS = 200 };

static char folder[FILES_PATH];

static void write_file(const char *text) {
    char path[FILES_PATH];
    files_join(path, folder, PREDICTION_FILE);
    assert_true(files_write(path, text));
}

typedef struct Each {
    int labs, predictions;
} Each;

static void load(Rubric *rubric, const char *id) {
    char path[FILES_PATH];
    assert_true(places_find_lab(path, id));
    if (!rubric_load(rubric, path) || !predictions_fit(rubric))
        fail_msg("%s", check_message());
}

// Of each sheet: a question without holes, an answer that four digits tell, and that counts if it is exact.
static void check_sheets(const Rubric *rubric, int n) {
    const Prediction *prediction = prediction_find(rubric->id, n);
    double least = INFINITY, most = -INFINITY;
    for (int sheet = 1; sheet <= SHEETS; sheet++) {
        double given[PREDICTION_MAX_GIVEN];
        char question[PREDICTION_QUESTION];
        prediction_draw(prediction, n, sheet, given);
        prediction_question(prediction, given, question, sizeof question);
        const double answer = prediction->answer(given);
        if (strpbrk(question, "{}[]") || strlen(question) + 1 >= sizeof question || !isfinite(answer) ||
            fabs(answer) > 1e6 || (prediction->tolerance > 0 && fabs(answer) < 1e-6))
            fail_msg("lab %s, %c, sheet %d: %g, \"%s\"", rubric->id, 'a' + n, sheet, answer, question);
        least = fmin(least, answer);
        most = fmax(most, answer);
    }
    if (most - least <= 2 * prediction->tolerance * fabs(most))
        fail_msg("lab %s, %c: all sheets have one answer", rubric->id, 'a' + n);
}

// The text of the file with every answer left out.
static void blank(char *text) {
    for (char *at = text; (at = strchr(at, '\n')) && at[1];)
        if (++at, at[0] >= 'a' && at[0] <= 'd' && at[1] == ' ') {
            const size_t rest = strcspn(at + 2, "\n");
            at[2] = '?';
            memmove(at + 3, at + 2 + rest, strlen(at + 2 + rest) + 1);
        }
}

// The solution's numbers are right, and its questions are those that its sheet gives today.
static void check_solution(const Rubric *rubric) {
    Predictions predictions;
    predictions_begin(&predictions, rubric);
    assert_true(predictions_take(&predictions, rubric, rubric->folder));
    for (int n = 0; n < predictions.count; n++)
        if (!predictions.results[n].right)
            fail_msg("lab %s, %c: %s", rubric->id, 'a' + n, predictions.results[n].why);
    assert_string_equal(predictions.message, "");
    assert_int_equal(predictions_points(&predictions), predictions_max_points(&predictions));
    char path[FILES_PATH];
    files_join(path, rubric->folder, PREDICTION_FILE);
    char *handed_in = files_read(path, 1 << 16), *drawn = prediction_sheet_text(rubric, predictions.sheet);
    assert_non_null(handed_in);
    blank(handed_in);
    assert_string_equal(handed_in, drawn);
    free(handed_in);
    free(drawn);
}

// As it is handed out, and with another sheet than the numbers are of: no points.
static void check_nothing(const Rubric *rubric) {
    Predictions predictions;
    predictions_begin(&predictions, rubric);
    char *text = prediction_sheet_text(rubric, 0);
    write_file(text);
    free(text);
    assert_true(predictions_take(&predictions, rubric, folder));
    assert_int_equal(predictions_points(&predictions), 0);
    assert_int_equal(predictions.sheet, 0);
    assert_non_null(strstr(predictions.message, "it has no sheet yet: `make predictions LAB="));
}

static void check_lab(const char *id, void *context) {
    Each *each = context;
    Rubric rubric;
    load(&rubric, id);
    for (int n = 0; n < rubric.prediction_count; n++)
        check_sheets(&rubric, n);
    if (rubric.prediction_count > 0) {
        check_solution(&rubric);
        check_nothing(&rubric);
    }
    each->labs++;
    each->predictions += rubric.prediction_count;
    rubric_destroy(&rubric);
}

static void test_labs(void **unused) {
    (void)unused;
    Each each = {0};
    assert_true(places_list_labs(check_lab, &each));
    print_message("%d predictions of %d labs\n", each.predictions, each.labs);
    assert_true(each.predictions >= 2 * each.labs);
}

// Lab 04's first number, right and wrong, and the bounds of what is right.
static void test_judging(void **unused) {
    (void)unused;
    static const struct {
        double factor;
        bool right;
    } cases[] = {{1, true},      {1.019, true}, {0.981, true}, {1.021, false},
                 {0.979, false}, {-1, false},   {2, false}};
    Rubric rubric;
    Predictions predictions;
    load(&rubric, "04");
    double given[PREDICTION_MAX_GIVEN];
    prediction_draw(prediction_find("04", 0), 0, 4711, given);
    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[100];
        snprintf(text, sizeof text, "sheet 4711\na %.9g\n",
                 cases[i].factor * prediction_answer("04", 0, given));
        write_file(text);
        predictions_begin(&predictions, &rubric);
        assert_true(predictions_take(&predictions, &rubric, folder));
        assert_int_equal(predictions.results[0].right, cases[i].right);
        assert_int_equal(predictions_points(&predictions), cases[i].right ? rubric.prediction_points[0] : 0);
        assert_true(cases[i].right == !predictions.results[0].why[0]);
        assert_true(predictions_open(&predictions)); // b and c
    }
    write_file("sheet 4712\na 0.0125\n");
    prediction_draw(prediction_find("04", 0), 0, 4712, given);
    predictions_begin(&predictions, &rubric);
    assert_true(predictions_take(&predictions, &rubric, folder));
    assert_non_null(strstr(predictions.results[0].why, "0.0125 is not within 2 %"));
    rubric_destroy(&rubric);
}

static void make_big(const char *path) {
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs("sheet 4711\n", out);
    for (int i = 0; i < 1 << 20; i++)
        fputc('#', out);
    assert_int_equal(fclose(out), 0);
}

static void make_bytes(const char *path, const char *bytes, size_t size) {
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    assert_int_equal(fwrite(bytes, 1, size, out), size);
    assert_int_equal(fclose(out), 0);
}

static void make(const char *kind, const char *path) {
    static const char wide[] = "\xff\xfes\0h\0e\0e\0t\0", zero[] = "sheet 4711\na 1\0";
    if (strcmp(kind, "big") == 0)
        make_big(path);
    else if (strcmp(kind, "UTF-16") == 0)
        make_bytes(path, wide, sizeof wide - 1);
    else if (strcmp(kind, "docx") == 0)
        make_bytes(path, "PK\3\4\24\0word/document.xml", 23);
    else if (strcmp(kind, "zero") == 0)
        make_bytes(path, zero, sizeof zero - 1);
    else if (strcmp(kind, "link") == 0)
        assert_int_equal(symlink("/etc/passwd", path), 0);
    else if (strcmp(kind, "folder") == 0)
        assert_int_equal(mkdir(path, 0700), 0);
    else if (strcmp(kind, "pipe") == 0)
        assert_int_equal(mkfifo(path, 0600), 0);
}

// Whatever lies there, or nothing: no points, and one message that says why.
static void test_bad_files(void **unused) {
    (void)unused;
    static const char *const bad[][2] = {{"none", "no prediction is handed in"},
                                         {"big", "predictions.txt"},
                                         {"UTF-16", "UTF-16: save it as UTF-8"},
                                         {"docx", "a document of an office program: save it as plain text"},
                                         {"zero", "a byte 0"},
                                         {"link", "symbolic link"},
                                         {"folder", "predictions.txt"},
                                         {"pipe", "predictions.txt"}};
    Rubric rubric;
    Predictions predictions;
    load(&rubric, "04");
    for (size_t i = 0; i < COUNT(bad); i++) {
        char path[FILES_PATH];
        files_empty(folder);
        files_join(path, folder, PREDICTION_FILE);
        make(bad[i][0], path);
        predictions_begin(&predictions, &rubric);
        assert_true(predictions_take(&predictions, &rubric, folder));
        print_message("%s: %s\n", bad[i][0], predictions.message);
        assert_non_null(strstr(predictions.message, bad[i][1]));
        assert_int_equal(predictions_points(&predictions), 0);
        assert_true(predictions_open(&predictions));
    }
    files_empty(folder);
    rubric_destroy(&rubric);
}

// Names that systems and editors make of it.
static void test_renamed(void **unused) {
    (void)unused;
    static const char *const names[] = {"Predictions.txt", "predictions.txt.txt", "predictions (1).txt"};
    Rubric rubric;
    Predictions predictions;
    load(&rubric, "04");
    for (size_t i = 0; i < COUNT(names); i++) {
        char path[FILES_PATH];
        files_empty(folder);
        files_join(path, folder, names[i]);
        assert_true(files_write(path, "\xef\xbb\xbfsheet 4711\r\na 1\r\n"));
        predictions_begin(&predictions, &rubric);
        assert_true(predictions_take(&predictions, &rubric, folder));
        assert_int_equal(predictions.sheet, 4711);
        assert_string_equal(predictions.results[0].typed, "1");
    }
    files_empty(folder);
    rubric_destroy(&rubric);
}

// A sheet is drawn once; what stands in the file is never lost.
static void test_drawing(void **unused) {
    (void)unused;
    Rubric rubric;
    char path[FILES_PATH];
    bool drawn;
    load(&rubric, "04");
    files_join(path, folder, PREDICTION_FILE);
    char *handed_out = prediction_sheet_text(&rubric, 0);
    write_file(handed_out);
    assert_true(prediction_sheet_draw(&rubric, folder, &drawn) && drawn);
    char *first = files_read(path, 1 << 16);
    assert_true(prediction_sheet_draw(&rubric, folder, &drawn) && !drawn);
    char *second = files_read(path, 1 << 16);
    assert_string_equal(first, second);
    assert_string_not_equal(first, handed_out);
    free(handed_out), free(first), free(second);
    write_file("sheet ?\na 0.5\n"); // somebody typed before the questions were there
    assert_true(prediction_sheet_draw(&rubric, folder, &drawn) && !drawn);
    rubric_destroy(&rubric);
}

static int set_up(void **unused) {
    (void)unused;
    return files_make_temporary(folder) ? 0 : -1;
}

static int tear_down(void **unused) {
    (void)unused;
    files_remove(folder);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_labs), cmocka_unit_test(test_judging),
                                       cmocka_unit_test(test_bad_files), cmocka_unit_test(test_renamed),
                                       cmocka_unit_test(test_drawing)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
