// skeletons: writes the labs for students, made from solutions/: each source with every task left to do (or
// solved up to TASK, "3.5"), the questions to predict, the handout and its pictures, and nothing else:
// sources that the rubric does not list are the grader's. What is unchanged is not rewritten.
#include "scene/check.h"
#include "compile/lab_folder.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "compile/rubric_file.h"
#include "base/places.h"
#include "predict/prediction_sheet.h"
#include "predict/predictions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_OTHER = 4 << 20 }; // bytes of a picture or a handout

typedef struct SkeletonWriter {
    const char *output;
    Solved solved;
    Rubric rubric; // of the lab that is being written
    char from[FILES_PATH], to[FILES_PATH];
    bool ok;
} SkeletonWriter;

static bool ends_with(const char *name, const char *end) {
    return strlen(name) > strlen(end) && strcmp(name + strlen(name) - strlen(end), end) == 0;
}

// A source file is written without its solution, everything else as it is.
static bool write_copy(const char *from, const char *to, Solved solved, bool source) {
    size_t size = 0;
    bool changed = false;
    char *bytes = files_read_bytes(from, source ? DERIVE_MAX_FILE : MAX_OTHER, &size);
    char *skeleton = bytes && source ? task_blocks_select(from, bytes, solved, false) : NULL;
    const char *text = source ? skeleton : bytes;
    bool ok = text && files_write_changed(to, text, source ? strlen(text) : size, &changed);
    if (changed)
        puts(to);
    free(bytes);
    free(skeleton);
    return ok;
}

static bool is_students(const Rubric *rubric, const char *name) {
    for (int i = 0; i < rubric->file_count; i++)
        if (strcmp(rubric->files[i], name) == 0)
            return true;
    return false;
}

static void write_file(const char *name, void *context) {
    SkeletonWriter *writer = context;
    char from[FILES_PATH], to[FILES_PATH];
    if (!writer->ok || strcmp(name, PREDICTION_FILE) == 0 || ends_with(name, ".json") ||
        strcmp(name, "pictures") == 0 || ends_with(name, ".gp") || ends_with(name, ".mjs"))
        return;
    files_join(from, writer->from, name);
    files_join(to, writer->to, name);
    bool source = ends_with(name, ".c") || ends_with(name, ".h") || ends_with(name, ".vert") ||
                  ends_with(name, ".frag") || ends_with(name, ".geom") || ends_with(name, ".glsl");
    if (!source || is_students(&writer->rubric, name))
        writer->ok = write_copy(from, to, writer->solved, source);
}

// The questions of the predictions, without the numbers of any sheet.
static bool write_predictions(const SkeletonWriter *writer) {
    char to[FILES_PATH];
    bool changed;
    if (writer->rubric.prediction_count == 0)
        return true;
    if (!predictions_fit(&writer->rubric))
        return false;
    files_join(to, writer->to, PREDICTION_FILE);
    char *text = prediction_sheet_text(&writer->rubric, 0);
    const bool ok = files_write_changed(to, text, strlen(text), &changed);
    if (changed)
        puts(to);
    free(text);
    return ok;
}

static void write_lab(const char *id, void *context) {
    SkeletonWriter *writer = context;
    char folder[FILES_PATH];
    if (!writer->ok || !places_find_lab(writer->from, id))
        return;
    files_join(writer->to, writer->output, strrchr(writer->from, '/') + 1);
    snprintf(folder, sizeof folder, "%.4000s/", writer->to);
    writer->ok = rubric_load(&writer->rubric, writer->from) && files_make_folder(folder) &&
                 files_list(writer->from, write_file, writer) && write_predictions(writer);
    rubric_destroy(&writer->rubric);
}

static bool check(void *settings, const Operands *operands) {
    SkeletonWriter *writer = settings;
    const char *task = operands->texts[1];
    writer->output = operands->texts[0];
    writer->solved = operands->count == 2 ? (Solved){SOLVED_UP_TO, task} : (Solved){SOLVED_NONE, NULL};
    if (operands->count < 2 || option_task(&task, task))
        return true;
    check_clear();
    return check_fail("TASK is a task like 3.2, not \"%s\"", operands->texts[1]);
}

static const CommandLine command_line = {
    .program = "skeletons",
    .forms = "OUTPUT [TASK]",
    .about = "Makes the labs for students from solutions/, in the folder OUTPUT: with nothing solved, or all "
             "up to TASK,\n"
             "for instance 3.5.\n",
    .options = (const Option[]){{0}},
    .operand = "OUTPUT",
    .least = 1,
    .most = 2,
    .check = check,
};

int main(int count, char **arguments) {
    static SkeletonWriter writer = {.ok = true};
    command_line_take(&command_line, &writer, count, arguments);
    writer.ok = places_list_labs(write_lab, &writer) && writer.ok;
    if (!writer.ok)
        fprintf(stderr, "skeletons: %s\n", check_message());
    return writer.ok ? 0 : 1;
}
