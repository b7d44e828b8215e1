#include "compile/rubric.h"

#include "scene/check.h"
#include "base/files.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

enum { TEXTS = 512 };

struct RubricJson {
    json_t *documents[4];
    char *texts[TEXTS]; // strings joined from arrays of lines
    int text_count;
};

static json_t *load_document(Rubric *rubric, int slot, const char *name, json_type type) {
    char path[FILES_PATH];
    json_error_t error;
    files_join(path, rubric->folder, name);
    json_t *document = json_load_file(path, 0, &error);
    rubric->json->documents[slot] = document;
    if (!document)
        check_fail("%s:%d: %s", path, error.line, error.text);
    else if (json_typeof(document) != type)
        check_fail("%s:1: expected %s", path, type == JSON_OBJECT ? "an object { }" : "a list [ ]");
    return document && json_typeof(document) == type ? document : NULL;
}

static bool missing(const Rubric *rubric, const char *file, int index, const char *key) {
    return check_fail("%s/%s: entry %d needs \"%s\"", rubric->folder, file, index + 1, key);
}

static bool read_knobs(Check *check, json_t *knobs) {
    const char *name;
    json_t *value;
    json_object_foreach(knobs, name, value) {
        if (check->knob_count == RUBRIC_MAX_KNOBS)
            return check_fail("check \"%s\" sets more than %d knobs", check->name, RUBRIC_MAX_KNOBS);
        check->knobs[check->knob_count].name = name;
        check->knobs[check->knob_count++].value = (float)json_number_value(value);
    }
    return true;
}

static bool read_check(Rubric *rubric, json_t *entry, int index) {
    Check *check = &rubric->checks[rubric->check_count++];
    *check = (Check){.name = json_string_value(json_object_get(entry, "name")),
                     .task = json_string_value(json_object_get(entry, "task")),
                     .view = json_string_value(json_object_get(entry, "view")),
                     .scene = json_string_value(json_object_get(entry, "scene")),
                     .points = (int)json_integer_value(json_object_get(entry, "points")),
                     .variants = (int)json_integer_value(json_object_get(entry, "variants")),
                     .optional = json_is_true(json_object_get(entry, "optional"))};
    if (!check->name || !check->task || !check->view || !check->scene)
        return missing(rubric, "rubric.json", index, "name\", \"task\", \"view\" and \"scene");
    if (check->points <= 0 || check->variants <= 0)
        return missing(rubric, "rubric.json", index, "points\" and \"variants\" above 0: \"points");
    return read_knobs(check, json_object_get(entry, "knobs"));
}

static bool read_files(Rubric *rubric, json_t *files) {
    size_t i;
    json_t *file;
    json_array_foreach(files, i, file) {
        const char *name = json_string_value(file);
        if (!name || strchr(name, '/') || name[0] == '.' || name[0] == '-' || i == RUBRIC_MAX_FILES)
            return check_fail("%s/rubric.json: \"files\" takes at most %d plain names", rubric->folder,
                              RUBRIC_MAX_FILES);
        rubric->files[rubric->file_count++] = name;
    }
    return rubric->file_count > 0 || check_fail("%s/rubric.json: \"files\" is missing", rubric->folder);
}

static bool read_rubric(Rubric *rubric) {
    json_t *root = load_document(rubric, 0, "rubric.json", JSON_OBJECT), *entry;
    if (!root)
        return false;
    size_t i;
    rubric->title = json_string_value(json_object_get(root, "title"));
    rubric->pass_mark = json_number_value(json_object_get(root, "pass_mark"));
    json_t *checks = json_object_get(root, "checks");
    if (!rubric->title || rubric->pass_mark <= 0 || json_array_size(checks) == 0)
        return check_fail("%s/rubric.json needs \"title\", \"pass_mark\" and \"checks\"", rubric->folder);
    if (json_array_size(checks) > RUBRIC_MAX_CHECKS)
        return check_fail("%s/rubric.json: more than %d checks", rubric->folder, RUBRIC_MAX_CHECKS);
    json_array_foreach(checks, i, entry) {
        if (!read_check(rubric, entry, (int)i))
            return false;
    }
    return read_files(rubric, json_object_get(root, "files"));
}

// A string, or a list of lines that are joined.
static const char *read_text(Rubric *rubric, json_t *value) {
    struct RubricJson *json = rubric->json;
    if (!json_is_array(value))
        return json_string_value(value);
    size_t i, size = 1;
    json_t *line;
    json_array_foreach(value, i, line) size += json_string_length(line) + 1;
    if (json->text_count == TEXTS)
        return NULL;
    char *text = json->texts[json->text_count++] = calloc(size, 1);
    json_array_foreach(value, i, line)
        check_append(text, size, "%s%s", i ? "\n" : "", json_string_value(line));
    return text;
}

static bool read_change(Rubric *rubric, const char *file, int index, json_t *entry, Change *change) {
    change->name = json_string_value(json_object_get(entry, "name"));
    change->task = json_string_value(json_object_get(entry, "task"));
    change->hint = read_text(rubric, json_object_get(entry, "hint"));
    size_t i;
    json_t *edit;
    json_array_foreach(json_object_get(entry, "edits"), i, edit) {
        if (i == RUBRIC_MAX_EDITS)
            return check_fail("%s/%s: entry %d has more than %d edits", rubric->folder, file, index + 1,
                              RUBRIC_MAX_EDITS);
        Edit *e = &change->edits[change->edit_count++];
        *e = (Edit){.file = json_string_value(json_object_get(edit, "file")),
                    .find = read_text(rubric, json_object_get(edit, "find")),
                    .replace = read_text(rubric, json_object_get(edit, "replace"))};
        if (!e->file || !e->find || !e->replace)
            return missing(rubric, file, index, "edits\" with \"file\", \"find\" and \"replace");
    }
    if (!change->name || (change->edit_count == 0 && json_object_get(entry, "edits")))
        return missing(rubric, file, index, "name\" and \"edits");
    return true;
}

static bool read_changes(Rubric *rubric, int slot, const char *file, Change **changes, int *count) {
    json_t *root = load_document(rubric, slot, file, JSON_ARRAY), *entry;
    size_t i;
    if (!root)
        return false;
    *changes = calloc(json_array_size(root) + 1, sizeof **changes);
    json_array_foreach(root, i, entry) {
        if (!read_change(rubric, file, (int)i, entry, &(*changes)[(*count)++]))
            return false;
    }
    return true;
}

static bool read_hints(Rubric *rubric) {
    json_t *root = load_document(rubric, 3, "hints.json", JSON_OBJECT), *texts, *text;
    const char *task;
    size_t i;
    if (!root)
        return false;
    rubric->hints = calloc(json_object_size(root) + 1, sizeof *rubric->hints);
    json_object_foreach(root, task, texts) {
        Hint *hint = &rubric->hints[rubric->hint_count];
        *hint = (Hint){.task = task, .texts = calloc(json_array_size(texts) + 1, sizeof *hint->texts)};
        json_array_foreach(texts, i, text) hint->texts[hint->count++] = read_text(rubric, text);
        rubric->hint_count++;
    }
    return true;
}

bool rubric_load(Rubric *rubric, const char *folder) {
    *rubric = (Rubric){.folder = strdup(folder), .json = calloc(1, sizeof(struct RubricJson))};
    const char *slash = strrchr(folder, '/');
    memcpy(rubric->id, slash ? slash + 1 : folder, 2);
    if (read_rubric(rubric) &&
        read_changes(rubric, 1, "mistakes.json", &rubric->mistakes, &rubric->mistake_count) &&
        read_changes(rubric, 2, "alternatives.json", &rubric->alternatives, &rubric->alternative_count) &&
        read_hints(rubric))
        return true;
    rubric_destroy(rubric);
    return false;
}

void rubric_destroy(Rubric *rubric) {
    for (int i = 0; rubric->json && i < 4; i++)
        json_decref(rubric->json->documents[i]);
    for (int i = 0; rubric->json && i < rubric->json->text_count; i++)
        free(rubric->json->texts[i]);
    for (int i = 0; i < rubric->hint_count; i++)
        free(rubric->hints[i].texts);
    free(rubric->hints);
    free(rubric->mistakes);
    free(rubric->alternatives);
    free(rubric->json);
    free((char *)rubric->folder);
    *rubric = (Rubric){0};
}

int rubric_points(const Rubric *rubric) {
    int points = 0;
    for (int i = 0; i < rubric->check_count; i++)
        points += rubric->checks[i].points;
    return points;
}

const char *rubric_task(const Rubric *rubric, int n) {
    for (int c = 0; c < rubric->check_count; c++) {
        const char *dot = strchr(rubric->checks[c].task, '.');
        if (dot && atoi(dot + 1) == n)
            return rubric->checks[c].task;
    }
    return NULL;
}

int rubric_task_index(const Rubric *rubric, const char *task) {
    for (int i = 0; i < rubric->hint_count; i++)
        if (strcmp(rubric->hints[i].task, task) == 0)
            return i;
    return -1;
}

static const Change *find_change(const Rubric *rubric, const Change *changes, int count, const char *kind,
                                 const char *name) {
    for (int i = 0; i < count; i++)
        if (strcmp(changes[i].name, name) == 0)
            return &changes[i];
    check_fail("lab %s has no %s \"%s\" in %ss.json", rubric->id, kind, name, kind);
    return NULL;
}

const Change *rubric_mistake(const Rubric *rubric, const char *name) {
    return find_change(rubric, rubric->mistakes, rubric->mistake_count, "mistake", name);
}

const Change *rubric_alternative(const Rubric *rubric, const char *name) {
    return find_change(rubric, rubric->alternatives, rubric->alternative_count, "alternative", name);
}

const char *rubric_hint(const Rubric *rubric, const char *task, int n) {
    for (int i = 0; i < rubric->hint_count; i++)
        if (strcmp(rubric->hints[i].task, task) == 0)
            return n < rubric->hints[i].count ? rubric->hints[i].texts[n] : NULL;
    return NULL;
}
