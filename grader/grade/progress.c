// Reads, changes and writes the file of the progress under a lock; a file that is no progress is set aside,
// never overwritten.
#include "grade/progress.h"

#include "scene/check.h"
#include "base/files.h"
#include "base/places.h"

#include <fcntl.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

enum { MAX_FILE = 1 << 20, VERSION = 1, MAX_PAUSE = 30 * 60 };

static void find_file(char path[FILES_PATH]) {
    const char *other = getenv("SHADOW_LAB_PROGRESS");
    if (other && other[0])
        snprintf(path, FILES_PATH, "%s", other);
    else
        places_path(path, ".progress.json");
}

// Reads one lab's entry; false when it is not what we wrote.
static bool read_entry(LabProgress *lab, const char *id, json_t *entry) {
    const char *done_on = "";
    int done = 0;
    *lab = (LabProgress){0};
    if (strlen(id) != 2 ||
        json_unpack(entry, "{s:F, s:F, s:F, s:b, s?s}", "score", &lab->score, "max_score", &lab->max_score,
                    "best", &lab->best, "done", &done, "done_on", &done_on))
        return false;
    lab->done = done;
    snprintf(lab->id, sizeof lab->id, "%s", id);
    snprintf(lab->done_on, sizeof lab->done_on, "%s", done_on);
    return true;
}

static bool read_labs(Progress *progress, json_t *root) {
    const char *id;
    json_t *entry;
    progress->count = 0;
    if (json_integer_value(json_object_get(root, "version")) != VERSION ||
        !json_is_object(json_object_get(root, "labs")))
        return false;
    json_object_foreach(json_object_get(root, "labs"), id, entry) {
        if (progress->count == COURSE_MAX_LABS || !read_entry(&progress->labs[progress->count], id, entry))
            return false;
        progress->count++;
    }
    return true;
}

// Gives the damaged file a name that nothing else has.
static void set_aside(Progress *progress, const char *path, const char *why) {
    char aside[FILES_PATH + 32];
    int n = 1;
    do
        snprintf(aside, sizeof aside, "%s.damaged-%d", path, n++);
    while (files_exists(aside));
    if (rename(path, aside) == 0)
        snprintf(progress->note, sizeof progress->note,
                 "%.300s was damaged (%.160s); it is kept as %.320s, and the progress starts again", path,
                 why, aside);
}

// The whole file as JSON, freed by the caller; an empty one when there is none or it is damaged. NULL with a
// message when it cannot be read.
static json_t *load(Progress *progress, const char *path) {
    json_error_t error = {.text = "it is not what this version writes"};
    json_t *root = NULL;
    if (files_exists(path)) {
        char *text = files_read(path, MAX_FILE);
        if (!text)
            return NULL;
        root = json_loads(text, JSON_REJECT_DUPLICATES, &error);
        free(text);
        if (!root || !read_labs(progress, root)) {
            set_aside(progress, path, error.text);
            json_decref(root);
            root = NULL;
        }
    }
    if (!root)
        progress->count = 0;
    return root ? root : json_pack("{s:i, s:{}}", "version", VERSION, "labs");
}

bool progress_load(Progress *progress) {
    char path[FILES_PATH];
    *progress = (Progress){0};
    find_file(path);
    json_t *root = load(progress, path);
    json_decref(root);
    return root != NULL;
}

// A longer pause is no work. A clock that was put back adds nothing.
static void add_time(json_t *entry) {
    const double now = (double)time(NULL), last = json_number_value(json_object_get(entry, "last"));
    const double pause = now - last, worked = json_number_value(json_object_get(entry, "seconds"));
    json_object_set_new(entry, "last", json_real(now));
    json_object_set_new(entry, "seconds",
                        json_real(pause > 0 && pause <= MAX_PAUSE ? worked + pause : worked));
}

static void add_mistakes(json_t *entry, const MistakesMet *met) {
    json_t *mistakes = json_object_get(entry, "mistakes"), *old;
    size_t n;
    if (!json_is_array(mistakes))
        json_object_set_new(entry, "mistakes", mistakes = json_array());
    for (int i = 0; met && i < met->count; i++) {
        bool known = false;
        json_array_foreach(mistakes, n, old) known =
            known || (json_is_string(old) && strcmp(json_string_value(old), met->names[i]) == 0);
        if (!known)
            json_array_append_new(mistakes, json_string(met->names[i]));
    }
}

// Changes one lab's entry; what else stands in it stays.
static void update(json_t *root, const LabProgress *old, const char *id, double score, double max_score,
                   bool done, const MistakesMet *met) {
    json_t *labs = json_object_get(root, "labs"), *entry = json_object_get(labs, id);
    double best = old && old->best > score ? old->best : score;
    if (!entry)
        json_object_set_new(labs, id, entry = json_object());
    json_object_set_new(entry, "score", json_real(score));
    json_object_set_new(entry, "max_score", json_real(max_score));
    json_object_set_new(entry, "best", json_real(best));
    json_object_set_new(entry, "done", json_boolean(done));
    add_time(entry);
    add_mistakes(entry, met);
    if (done && !json_object_get(entry, "done_on")) {
        char day[16];
        time_t now = time(NULL);
        strftime(day, sizeof day, "%Y-%m-%d", localtime(&now));
        json_object_set_new(entry, "done_on", json_string(day));
    }
}

static bool write_file(const char *path, const json_t *root) {
    char *text = json_dumps(root, JSON_INDENT(2) | JSON_REAL_PRECISION(10) | JSON_SORT_KEYS), *line = NULL;
    bool ok = text && asprintf(&line, "%s\n", text) > 0 && files_write_whole(path, line, true);
    free(text);
    free(line);
    return ok;
}

// Holds off others that record at this moment: a lock on the file's folder, which is always there. Where it
// cannot be had (some network drives) the record is made all the same. Closing the descriptor ends it.
static int lock_folder(const char *path) {
    char folder[FILES_PATH];
    files_folder_of(folder, path);
    int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0)
        flock(descriptor, LOCK_EX);
    return descriptor;
}

bool progress_record(Progress *progress, const char *id, double score, double max_score, bool done,
                     const MistakesMet *met) {
    char path[FILES_PATH];
    find_file(path);
    int lock = lock_folder(path);
    json_t *root = load(progress, path);
    if (root) {
        update(root, progress_find(progress, id), id, score, max_score, done, met);
        read_labs(progress, root);
    }
    bool ok = root && write_file(path, root);
    json_decref(root);
    if (lock >= 0)
        close(lock);
    return ok;
}

const LabProgress *progress_find(const Progress *progress, const char *id) {
    for (int i = 0; i < progress->count; i++)
        if (strcmp(progress->labs[i].id, id) == 0)
            return &progress->labs[i];
    return NULL;
}
