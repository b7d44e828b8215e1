// skeletons: writes the labs for students, made from solutions/: each source with every task
// left to do (or solved up to TASK, "3.5"), the handout and its pictures, and nothing else. What is unchanged
// is not rewritten.
#include "scene/check.h"
#include "compile/lab_folder.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Job {
    const char *output;
    Solved solved;
    char from[FILES_PATH], to[FILES_PATH];
    bool ok;
} Job;

// True when the file already holds just these bytes.
static bool holds(const char *path, const char *bytes, size_t size) {
    FILE *file = fopen(path, "rb");
    char *old = malloc(size + 1);
    bool same = file && old && fread(old, 1, size + 1, file) == size && memcmp(old, bytes, size) == 0;
    free(old);
    if (file)
        fclose(file);
    return same;
}

static bool write_changed(const char *path, const char *bytes, size_t size) {
    if (holds(path, bytes, size))
        return true;
    FILE *file = fopen(path, "wb");
    bool ok = file && fwrite(bytes, 1, size, file) == size;
    if (file && fclose(file) != 0)
        ok = false;
    printf("%s\n", path);
    return ok || check_fail("%s cannot be written", path);
}

static bool ends_with(const char *name, const char *end) {
    return strlen(name) > strlen(end) && strcmp(name + strlen(name) - strlen(end), end) == 0;
}

static bool copy_file(const char *from, const char *to) {
    FILE *file = fopen(from, "rb");
    char *bytes = malloc(1 << 22);
    size_t size = file && bytes ? fread(bytes, 1, 1 << 22, file) : 0;
    bool ok = size > 0 ? write_changed(to, bytes, size) : check_fail("%s cannot be read", from);
    free(bytes);
    if (file)
        fclose(file);
    return ok;
}

static bool write_skeleton(const char *from, const char *to, Solved solved) {
    char *text = files_read(from, DERIVE_MAX_FILE);
    char *skeleton = text ? task_blocks_select(from, text, solved, false) : NULL;
    bool ok = skeleton && write_changed(to, skeleton, strlen(skeleton));
    free(text);
    free(skeleton);
    return ok;
}

static void write_file(const char *name, void *context) {
    Job *job = context;
    char from[FILES_PATH], to[FILES_PATH];
    if (!job->ok || ends_with(name, ".json") || strcmp(name, "pictures") == 0)
        return;
    files_join(from, job->from, name);
    files_join(to, job->to, name);
    bool source = ends_with(name, ".c") || ends_with(name, ".h") || ends_with(name, ".vert") ||
                  ends_with(name, ".frag") || ends_with(name, ".geom") || ends_with(name, ".glsl");
    job->ok = source ? write_skeleton(from, to, job->solved) : copy_file(from, to);
}

static void write_lab(const char *id, void *context) {
    Job *job = context;
    char folder[FILES_PATH];
    if (!job->ok || !places_find_lab(job->from, id))
        return;
    files_join(job->to, job->output, strrchr(job->from, '/') + 1);
    snprintf(folder, sizeof folder, "%.4000s/", job->to);
    job->ok = files_make_folder(folder) && files_list(job->from, write_file, job);
}

static bool check(void *settings, const Operands *operands) {
    Job *job = settings;
    const char *task = operands->texts[1];
    job->output = operands->texts[0];
    job->solved = operands->count == 2 ? (Solved){SOLVED_UP_TO, task} : (Solved){SOLVED_NONE, NULL};
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
    static Job job = {.ok = true};
    command_line_take(&command_line, &job, count, arguments);
    job.ok = places_list_labs(write_lab, &job) && job.ok;
    if (!job.ok)
        fprintf(stderr, "skeletons: %s\n", check_message());
    return job.ok ? 0 : 1;
}
