// stability: where each method breaks. Runs the rows, prints a line for each, and writes what they found.
#include "check.h"
#include "files.h"
#include "home.h"
#include "stability/row_json.h"

#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: build/stability [options]\n"
    "  --row N            only this row; may be repeated\n"
    "  --output DIR       writes stability.json and the frames (default build/study)\n"
    "  --mistake NN:NAME  lab NN is drawn with a mistake of its mistakes.json\n";

typedef struct Options {
    bool rows[ROW_COUNT + 1];
    char output[FILES_PATH];
    Bench bench;
} Options;

static bool take_row(Options *options, const char *text) {
    char *end;
    long number = strtol(text, &end, 10);
    if (end == text || *end || !row_find((int)number))
        return check_fail("--row takes the number of a row, 1 to %d, not \"%s\"", ROW_COUNT, text);
    options->rows[number] = true;
    return true;
}

static bool take_mistake(Options *options, char *text) {
    char *colon = strchr(text, ':');
    if (!colon)
        return check_fail("--mistake takes NN:NAME, not \"%s\"", text);
    *colon = '\0';
    options->bench.fault_lab = text;
    options->bench.fault = colon + 1;
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
    home_build_path(options->output, "study");
    opterr = 0;
    for (int option; (option = getopt_long(count, arguments, "", table, NULL)) != -1;)
        if (!take_option(options, option, optarg))
            return false;
    bool all = memchr(options->rows, true, sizeof options->rows) == NULL;
    for (int i = 1; all && i <= ROW_COUNT; i++)
        options->rows[i] = true;
    return optind == count || check_fail("\"%s\" is not an option", arguments[optind]);
}

static void print_line(const Row *row, RowStatus status, const CurveVerdict *worst, const Curve *curve,
                       const char *message) {
    printf("%2d  %-9s  %-28s ", row->number, row_status_name(status), row->name);
    if (message)
        printf("%s\n", message);
    else if (curve)
        printf("%s: %.4g, expected %.4g, %.0f %% of the tolerance\n", curve->name, worst->measured,
               worst->expected, 100 * worst->share);
    else
        printf("%s\n", row->run ? "nothing was measured" : "no lab has this method yet");
    fflush(stdout);
}

static bool write_frames(const Row *row, const Findings *findings, const char *folder) {
    char path[FILES_PATH], name[64];
    for (int i = 0; i < ROW_FRAMES; i++) {
        row_frame_name(name, row, i);
        files_join(path, folder, name);
        if (findings->frames[i].strip.rgba && !image_write_png(&findings->frames[i].strip, path))
            return false;
    }
    return true;
}

// False when the row fails.
static bool run_row(Options *options, const Row *row, json_t *rows) {
    static Findings findings;
    CurveVerdict worst;
    const Curve *curve;
    check_clear();
    bool ran = !row->run || row->run(&options->bench, &findings);
    const char *message = ran ? NULL : check_message();
    RowStatus status = row_judge(row, ran, &findings, &worst, &curve);
    print_line(row, status, &worst, curve, message);
    json_array_append_new(rows, row_json(row, &findings, message));
    if (!write_frames(row, &findings, options->output)) {
        fprintf(stderr, "stability: %s\n", check_message());
        status = ROW_FAIL;
    }
    findings_destroy(&findings);
    return status != ROW_FAIL;
}

static bool write_json(json_t *rows, const char *folder) {
    char path[FILES_PATH];
    json_t *root = json_pack("{s:i, s:o}", "version", 1, "rows", rows);
    files_join(path, folder, "stability.json");
    bool ok = root && json_dump_file(root, path, JSON_INDENT(1) | JSON_REAL_PRECISION(8)) == 0;
    json_decref(root);
    return ok || check_fail("%s cannot be written", path);
}

static int run(Options *options) {
    json_t *rows = json_array();
    int failed = 0;
    if (!files_make_folder(options->output)) {
        fprintf(stderr, "stability: %s\n", check_message());
        return 1;
    }
    for (int i = 1; i <= ROW_COUNT; i++)
        if (options->rows[i] && row_find(i))
            failed += !run_row(options, row_find(i), rows);
    bench_close(&options->bench);
    if (write_json(rows, options->output))
        return failed > 0;
    fprintf(stderr, "stability: %s\n", check_message());
    return 1;
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
