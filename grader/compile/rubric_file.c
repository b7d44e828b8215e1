// The tables of the keys of rubric.json and of a check, and the way through all files of a lab's rubric.
#include "compile/rubric_file.h"

#include "compile/rubric_changes.h"
#include "compile/rubric_choices.h"
#include "compile/rubric_names.h"
#include "base/file_watch.h"
#include "base/places.h"
#include "scene/check.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const JsonField rubric_fields[] = {
    {"title", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_TITLE},
    {"pass_mark", FIELD_NUMBER, FIELD_NEEDED, 0, 100},
    {"files", FIELD_LIST, FIELD_NEEDED, 1, RUBRIC_MAX_FILES},
    {"checks", FIELD_LIST, FIELD_NEEDED, 1, RUBRIC_MAX_CHECKS},
    {"predictions", FIELD_LIST, FIELD_OPTIONAL, 1, RUBRIC_MAX_PREDICTIONS},
    {"remarks", FIELD_FLAG, FIELD_OPTIONAL, 0, 0},
    {"also right", FIELD_LIST, FIELD_OPTIONAL, 0, RUBRIC_MAX_ALSO},
    {0}};

static const JsonField check_fields[] = {{"name", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                         {"task", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                         {"points", FIELD_WHOLE, FIELD_NEEDED, 1, RUBRIC_MAX_POINTS},
                                         {"view", FIELD_NAME, FIELD_NEEDED, 1, LAB_MAX_NAME - 1},
                                         {"scene", FIELD_OTHER, FIELD_NEEDED, 0, 0},
                                         {"variants", FIELD_WHOLE, FIELD_NEEDED, 1, EXAM_MAX_VARIANTS},
                                         {"optional", FIELD_FLAG, FIELD_OPTIONAL, 0, 0},
                                         {"large frame", FIELD_FLAG, FIELD_OPTIONAL, 0, 0},
                                         {"knobs", FIELD_KEYS, FIELD_OPTIONAL, 0, LAB_MAX_KNOBS},
                                         {0}};

static const JsonField file_name = {"", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME};
static const JsonField prediction_points = {"", FIELD_WHOLE, FIELD_NEEDED, 1, RUBRIC_MAX_POINTS};
static const JsonField alternative_name = {"", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME};

static const char *text_of(const json_t *object, const char *key) {
    return json_string_value(json_object_get(object, key));
}

static bool read_check(Rubric *rubric, const JsonPlace *place, json_t *entry) {
    if (!json_fields_check(place, entry, check_fields))
        return false;
    Check *check = &rubric->checks[rubric->check_count];
    *check = (Check){.name = text_of(entry, "name"),
                     .task = text_of(entry, "task"),
                     .view = text_of(entry, "view"),
                     .points = (int)json_integer_value(json_object_get(entry, "points")),
                     .variants = (int)json_integer_value(json_object_get(entry, "variants")),
                     .optional = json_is_true(json_object_get(entry, "optional")),
                     .large = json_is_true(json_object_get(entry, "large frame"))};
    for (int c = 0; c < rubric->check_count; c++)
        if (strcmp(rubric->checks[c].name, check->name) == 0)
            return json_fields_fail(place, "name", "checks[%d] has this name, too; write another", c);
    rubric->check_count++;
    return rubric_names_task(rubric, place, check->task) &&
           rubric_choices_scenes(check, place, json_object_get(entry, "scene")) &&
           rubric_choices_knobs(check, place, json_object_get(entry, "knobs"));
}

static bool read_file(Rubric *rubric, const JsonPlace *place, const json_t *entry) {
    static const char allowed[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
    const char *name = json_string_value(entry);
    if (!json_fields_fits(place, entry, &file_name))
        return false;
    if (!isalnum((unsigned char)name[0]) || strspn(name, allowed) != strlen(name) ||
        !file_watch_is_source(name))
        return json_fields_fail(
            place, "",
            "\"%s\" is no plain name of a C or GLSL file; write letters, digits, \"_\" and an "
            "ending, without a folder",
            name);
    for (int i = 0; i < rubric->file_count; i++)
        if (strcmp(rubric->files[i], name) == 0)
            return json_fields_fail(place, "", "\"%s\" is in the list twice; remove one", name);
    rubric->files[rubric->file_count++] = name;
    return true;
}

static bool read_predictions(Rubric *rubric, const JsonPlace *file, const json_t *list) {
    size_t i;
    json_t *entry;
    json_array_foreach(list, i, entry) {
        const JsonPlace place = json_fields_enter(file, "predictions", i, NULL);
        if (!json_fields_fits(&place, entry, &prediction_points))
            return false;
        rubric->prediction_points[rubric->prediction_count++] = (int)json_integer_value(entry);
    }
    return true;
}

static bool read_rubric(Rubric *rubric, const JsonPlace *file, json_t *root) {
    size_t i;
    json_t *entry;
    if (!json_fields_check(file, root, rubric_fields))
        return false;
    rubric->title = text_of(root, "title");
    rubric->pass_mark = json_number_value(json_object_get(root, "pass_mark"));
    rubric->remarks = json_is_true(json_object_get(root, "remarks"));
    json_array_foreach(json_object_get(root, "files"), i, entry) {
        const JsonPlace place = json_fields_enter(file, "files", i, NULL);
        if (!read_file(rubric, &place, entry))
            return false;
    }
    if (!rubric_names_file(rubric, "lab.c"))
        return json_fields_fail(file, "files", "\"lab.c\" is missing; add it");
    json_array_foreach(json_object_get(root, "checks"), i, entry) {
        const JsonPlace place = json_fields_enter(file, "checks", i, text_of(entry, "name"));
        if (!read_check(rubric, &place, entry))
            return false;
    }
    return read_predictions(rubric, file, json_object_get(root, "predictions"));
}

typedef struct Document {
    const char *name;
    json_type type;
    bool (*read)(Rubric *rubric, const JsonPlace *file, json_t *root);
} Document;

static const Document documents[RUBRIC_FILES] = {
    [RUBRIC_JSON] = {"rubric.json", JSON_OBJECT, read_rubric},
    [MISTAKES_JSON] = {"mistakes.json", JSON_ARRAY, rubric_changes_mistakes},
    [ALTERNATIVES_JSON] = {"alternatives.json", JSON_ARRAY, rubric_changes_alternatives},
    [HINTS_JSON] = {"hints.json", JSON_OBJECT, rubric_changes_hints},
};

// Names of alternatives, which stand in the next file.
static bool read_also(Rubric *rubric) {
    size_t i;
    json_t *entry;
    const JsonPlace file = {.folder = rubric->folder, .file = documents[RUBRIC_JSON].name};
    json_array_foreach(json_object_get(json_array_get(rubric->json, 1 + RUBRIC_JSON), "also right"), i,
                       entry) {
        const JsonPlace place = json_fields_enter(&file, "also right", i, NULL);
        if (!json_fields_fits(&place, entry, &alternative_name))
            return false;
        const Change *change = rubric_alternative(rubric, json_string_value(entry));
        check_clear();
        rubric->also[rubric->also_count++] = change;
        if (!change)
            return json_fields_fail(&place, "", "alternatives.json has no \"%s\"; write one of its names",
                                    json_string_value(entry));
    }
    return true;
}

static bool read_document(Rubric *rubric, const Document *document, const char *text) {
    const JsonPlace file = {.folder = rubric->folder, .file = document->name};
    json_t *root = json_fields_read(&file, text, text ? strlen(text) : 0, document->type);
    if (!root)
        return false;
    json_array_append_new(rubric->json, root);
    return document->read(rubric, &file, root);
}

bool rubric_load(Rubric *rubric, const char *folder) {
    static const char *const none[RUBRIC_FILES] = {0};
    return rubric_read(rubric, folder, none);
}

bool rubric_read(Rubric *rubric, const char *folder, const char *const texts[RUBRIC_FILES]) {
    *rubric = (Rubric){.folder = strdup(folder), .json = json_array()};
    const char *slash = strrchr(folder, '/'), *name = slash ? slash + 1 : folder;
    bool ok = json_array_append_new(rubric->json, json_array()) == 0; // texts that were joined from lines
    INVARIANT(ok && rubric->folder);
    ok = places_is_lab_name(name) ||
         check_fail("%s: the folder of a lab is named NN-name, as 03-shadow-map", folder);
    memcpy(rubric->id, name, ok ? 2 : 0);
    for (int i = 0; ok && i < RUBRIC_FILES; i++)
        ok = read_document(rubric, &documents[i], texts[i]);
    ok = ok && read_also(rubric);
    if (!ok)
        rubric_destroy(rubric);
    return ok;
}
