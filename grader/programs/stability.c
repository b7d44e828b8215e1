// stability: where each method breaks. Runs the rows, prints a line for each, and writes what they found.
#include "scene/check.h"
#include "base/files.h"
#include "base/places.h"
#include "stability/plot.h"
#include "stability/row_json.h"
#include "stability/suite_html.h"

#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: build/stability [options]\n"
    "  --row N            only this row; may be repeated\n"
    "  --output DIR       writes stability.json, .html and the figures (default build/study)\n"
    "  --mistake NN:NAME  lab NN is drawn with a mistake of its mistakes.json\n";

typedef struct Options {
    const Row *rows[ROW_MOST]; // all, in order
    bool chosen[ROW_MOST];
    int row_count;
    char output[FILES_PATH];
    LabSet labs;
} Options;

static bool take_row(Options *options, const char *text) {
    char numbers[1024] = "", *end;
    long number = strtol(text, &end, 10);
    bool found = false;
    for (int i = 0; i < options->row_count; i++) {
        bool this_one = end != text && !*end && options->rows[i]->number == number;
        options->chosen[i] = options->chosen[i] || this_one;
        found = found || this_one;
        check_append(numbers, sizeof numbers, "%s%d", i ? ", " : "", options->rows[i]->number);
    }
    return found || check_fail("--row takes the number of a row, not \"%s\"; the rows are %s", text, numbers);
}

static bool take_mistake(Options *options, char *text) {
    char *colon = strchr(text, ':');
    if (!colon)
        return check_fail("--mistake takes NN:NAME, not \"%s\"", text);
    *colon = '\0';
    options->labs.fault_lab = text;
    options->labs.fault = colon + 1;
    return true;
}

static bool take_option(Options *options, int option, char *value) {
    switch (option) {
    case 'r':
        return take_row(options, value);
    case 'm':
        return take_mistake(options, value);
    case 'o':
        snprintf(options->output, sizeof options->output, "%s", value);
        return true;
    default:
        return check_fail("unknown option, or one without its value");
    }
}

static bool parse(Options *options, int count, char **arguments) {
    static const struct option table[] = {{"row", required_argument, NULL, 'r'},
                                          {"output", required_argument, NULL, 'o'},
                                          {"mistake", required_argument, NULL, 'm'},
                                          {0}};
    places_build_path(options->output, "study");
    options->row_count = row_list(options->rows);
    opterr = 0;
    for (int option; (option = getopt_long(count, arguments, "", table, NULL)) != -1;)
        if (!take_option(options, option, optarg))
            return false;
    if (memchr(options->chosen, true, sizeof options->chosen) == NULL)
        memset(options->chosen, true, sizeof options->chosen);
    return optind == count || check_fail("\"%s\" is not an option", arguments[optind]);
}

static void print_line(const RowResult *result) {
    printf("%2d  %-9s  %-22s ", result->row->number, row_status_name(result->status), result->row->name);
    if (result->message[0])
        printf("%s\n", result->message);
    else if (result->curve)
        printf("%s: %.4g, expected %s%.4g, %.0f %% of the tolerance\n", result->curve->name,
               result->worst.measured, curve_bound(result->curve), result->worst.expected,
               100 * result->worst.share);
    else
        printf("%s\n", result->row->run ? "nothing was measured" : "no lab has this method yet");
    fflush(stdout);
}

static bool write_json(const RowResult *results, int count, const char *folder) {
    char path[FILES_PATH];
    json_t *rows = json_array();
    for (int i = 0; i < count; i++)
        json_array_append_new(rows, row_json(&results[i]));
    json_t *root = json_pack("{s:i, s:o}", "version", 1, "rows", rows);
    files_join(path, folder, "stability.json");
    bool ok = root && json_dump_file(root, path, JSON_INDENT(1) | JSON_REAL_PRECISION(8)) == 0;
    json_decref(root);
    return ok || check_fail("%s cannot be written", path);
}

static bool write_page(const RowResult *results, int count, const char *folder) {
    char path[FILES_PATH];
    char *text = suite_html(results, count, folder);
    files_join(path, folder, "stability.html");
    bool ok = text && files_write(path, text);
    free(text);
    return ok;
}

// The number of rows that ran; *failed is that of those that fail.
static int run_rows(Options *options, RowResult *results, int *failed) {
    int count = 0;
    *failed = 0;
    for (int i = 0; i < options->row_count; i++)
        if (options->chosen[i]) {
            row_run(&results[count], options->rows[i], &options->labs);
            print_line(&results[count]);
            *failed += results[count++].status == ROW_FAIL;
        }
    lab_set_close(&options->labs);
    return count;
}

static int run(Options *options) {
    static RowResult results[ROW_MOST];
    int failed, count = run_rows(options, results, &failed);
    const char *folder = options->output;
    check_clear();
    bool ok = files_make_folder(folder) && write_json(results, count, folder) &&
              plot_all(results, count, folder) && write_page(results, count, folder);
    for (int i = 0; i < count; i++)
        findings_destroy(&results[i].findings);
    if (ok)
        printf("%d of %d rows fail; see %s/stability.html\n", failed, count, folder);
    else
        fprintf(stderr, "stability: %s\n", check_message());
    return !ok || failed > 0;
}

int main(int count, char **arguments) {
    static Options options;
    signal(SIGPIPE, SIG_IGN);
    if (!parse(&options, count, arguments)) {
        fprintf(stderr, "stability: %s\n%s", check_message(), usage);
        return 2;
    }
    return run(&options);
}
