// skeletons OUTPUT [TASK]: writes the labs for students, made from solutions/: each source with every task
// left to do (or solved up to TASK, "3.5"), the handout and its pictures, and nothing else: sources that the
// rubric does not list are the grader's. What is unchanged is not rewritten.
#include "scene/check.h"
#include "compile/lab_folder.h"
#include "base/places.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Job {
    const char *output;
    Solved solved;
    Rubric rubric; // of the lab that is being written
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

static bool is_students(const Rubric *rubric, const char *name) {
    for (int i = 0; i < rubric->file_count; i++)
        if (strcmp(rubric->files[i], name) == 0)
            return true;
    return false;
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
    if (!source)
        job->ok = copy_file(from, to);
    else if (is_students(&job->rubric, name))
        job->ok = write_skeleton(from, to, job->solved);
}

static void write_lab(const char *id, void *context) {
    Job *job = context;
    char folder[FILES_PATH];
    if (!job->ok || !places_find_lab(job->from, id))
        return;
    files_join(job->to, job->output, strrchr(job->from, '/') + 1);
    snprintf(folder, sizeof folder, "%.4000s/", job->to);
    job->ok = rubric_load(&job->rubric, job->from) && files_make_folder(folder) &&
              files_list(job->from, write_file, job);
    rubric_destroy(&job->rubric);
}

int main(int count, char **arguments) {
    static Job job = {.ok = true};
    if (count != 2 && count != 3) {
        fprintf(stderr, "usage: build/skeletons OUTPUT [TASK] (see `make skeletons`)\n");
        return 2;
    }
    job.output = arguments[1];
    job.solved = count == 3 ? (Solved){SOLVED_UP_TO, arguments[2]} : (Solved){SOLVED_NONE, NULL};
    job.ok = places_list_labs(write_lab, &job) && job.ok;
    if (!job.ok)
        fprintf(stderr, "skeletons: %s\n", check_message());
    return job.ok ? 0 : 1;
}
