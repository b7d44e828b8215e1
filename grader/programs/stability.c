// stability: where each method breaks. Runs the rows, prints a line for each, and writes what they found.
#include "scene/check.h"
#include "base/command_line.h"
#include "base/files.h"
#include "base/option_values.h"
#include "base/places.h"
#include "stability/plot.h"
#include "stability/row_json.h"
#include "stability/suite_html.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct StabilityCommand {
    const Row *rows[ROW_MOST]; // all, in order
    bool chosen[ROW_MOST];
    int row_count;
    const char *output;
    char fault_lab[3];
    LabSet labs;
} StabilityCommand;

static bool take_row(void *target, const char *text) {
    StabilityCommand *command = target;
    char numbers[1024] = "";
    int number = -1;
    bool found = false;
    if (!option_whole(&number, text, 0, 9999))
        check_clear();
    for (int i = 0; i < command->row_count; i++) {
        const int own = command->rows[i]->number;
        command->chosen[i] = command->chosen[i] || own == number;
        found = found || own == number;
        check_append(numbers, sizeof numbers, "%s%d", i ? ", " : "", own);
    }
    return found || check_fail("takes the number of a row, not \"%s\"; the rows are %s", text, numbers);
}

static bool take_mistake(void *target, const char *text) {
    StabilityCommand *command = target;
    const char *colon = strchr(text, ':');
    char lab[8] = "";
    if (!colon || colon == text || !colon[1])
        return check_fail("takes NN:NAME, not \"%s\"", text);
    snprintf(lab, sizeof lab, "%.*s", (int)(colon - text), text);
    command->labs.fault_lab = command->fault_lab;
    command->labs.fault = colon + 1;
    return option_lab(command->fault_lab, lab);
}

static bool take_without(void *target, const char *text) {
    StabilityCommand *command = target;
    return option_bit(&command->labs.without, text, SCENE_MAX_OBJECTS - 1);
}

static const Option options[] = {
    {"row", 0, "N", "only this row; may be repeated", 0, take_row},
    {"output", 0, "DIR", "writes stability.json, .html and the figures (default build/study)",
     offsetof(StabilityCommand, output), option_text},
    {"mistake", 0, "NN:NAME", "lab NN is drawn with a mistake of its mistakes.json", 0, take_mistake},
    {"without", 0, "N",
     "object N is left out of all scenes: of the rows that have it, those that need it fail; may "
     "be\nrepeated",
     0, take_without},
    {0}};

static bool check(void *settings, const Operands *operands) {
    StabilityCommand *command = settings;
    (void)operands;
    if (memchr(command->chosen, true, sizeof command->chosen) == NULL)
        memset(command->chosen, true, sizeof command->chosen);
    return true;
}

static const CommandLine command_line = {
    .program = "stability",
    .forms = "[options]",
    .about = "Shows where each method breaks: runs the rows, prints a line for each, and writes what they "
             "found.\n",
    .options = options,
    .ending = "exit status: 0; 1 a row fails; 2 usage\n",
    .check = check,
};

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

static bool has_left_out(const StabilityCommand *command, const RowResult *result) {
    return command->labs.without & ((1U << result->objects) - 1);
}

// The number of rows that ran; *failed is that of those that fail.
static int run_rows(StabilityCommand *command, RowResult *results, int *failed) {
    int count = 0;
    *failed = 0;
    for (int i = 0; i < command->row_count; i++)
        if (command->chosen[i]) {
            row_run(&results[count], command->rows[i], &command->labs);
            if (command->labs.without && !has_left_out(command, &results[count])) {
                findings_destroy(&results[count].findings);
                continue; // no scene of the row has one of these objects
            }
            print_line(&results[count]);
            *failed += results[count++].status == ROW_FAIL;
        }
    lab_set_close(&command->labs);
    return count;
}

static int run(StabilityCommand *command) {
    static RowResult results[ROW_MOST];
    int failed, count = run_rows(command, results, &failed);
    const char *folder = command->output;
    if (count == 0) {
        fprintf(stderr, "stability: none of these rows has an object that is left out\n");
        return 1;
    }
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
    static StabilityCommand command;
    char standard[FILES_PATH];
    places_build_path(standard, "study");
    command.output = standard;
    command.row_count = row_list(command.rows);
    ContextKind context = CONTEXT_ANY; // whoever draws settles it in the same way
    command_line_take(&command_line, &command, count, arguments);
    command_line_settle_context(&command_line, &context);
    return run(&command);
}
