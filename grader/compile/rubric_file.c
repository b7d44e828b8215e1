#include "compile/rubric_file.h"

#include "compile/rubric_changes.h"
#include "compile/rubric_names.h"
#include "base/file_watch.h"
#include "base/places.h"
#include "scene/check.h"
#include "scene/scene.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const JsonField rubric_fields[] = {{"title", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_TITLE},
                                          {"pass_mark", FIELD_NUMBER, FIELD_NEEDED, 0, 100},
                                          {"files", FIELD_LIST, FIELD_NEEDED, 1, RUBRIC_MAX_FILES},
                                          {"checks", FIELD_LIST, FIELD_NEEDED, 1, RUBRIC_MAX_CHECKS},
                                          {0}};

static const JsonField check_fields[] = {{"name", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                         {"task", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                         {"points", FIELD_WHOLE, FIELD_NEEDED, 1, RUBRIC_MAX_POINTS},
                                         {"view", FIELD_NAME, FIELD_NEEDED, 1, LAB_MAX_NAME - 1},
                                         {"scene", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                         {"variants", FIELD_WHOLE, FIELD_NEEDED, 1, EXAM_MAX_VARIANTS},
                                         {"optional", FIELD_FLAG, FIELD_OPTIONAL, 0, 0},
                                         {"knobs", FIELD_KEYS, FIELD_OPTIONAL, 0, LAB_MAX_KNOBS},
                                         {0}};

static const JsonField file_name = {"", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME};
static const JsonField knob_value = {"", FIELD_NUMBER, FIELD_NEEDED, -1e9, 1e9}; // its range: rubric_fit.h
static const char *text_of(const json_t *object, const char *key) {
    return json_string_value(json_object_get(object, key));
}

static bool check_scene(const JsonPlace *place, const char *name) {
    static Scene scene;
    char text[1200];
    check_clear();
    if (scene_make(&scene, name, &(Random){1}))
        return true;
    snprintf(text, sizeof text, "%s", check_message());
    check_clear();
    return json_fields_fail(place, "scene", "%s", text);
}

static bool read_knobs(Check *check, const JsonPlace *place, json_t *knobs) {
    const char *name;
    json_t *value;
    json_object_foreach(knobs, name, value) {
        JsonField field = knob_value;
        field.key = name;
        if (strlen(name) >= LAB_MAX_NAME)
            return json_fields_fail(place, "knobs",
                                    "a name is longer than %d bytes; write one of lab.c's table",
                                    LAB_MAX_NAME - 1);
        if (!json_fields_fits(place, value, &field))
            return false;
        check->knobs[check->knob_count].name = name;
        check->knobs[check->knob_count++].value = (float)json_number_value(value);
    }
    return true;
}

static bool read_check(Rubric *rubric, const JsonPlace *place, json_t *entry) {
    if (!json_fields_check(place, entry, check_fields))
        return false;
    Check *check = &rubric->checks[rubric->check_count];
    *check = (Check){.name = text_of(entry, "name"),
                     .task = text_of(entry, "task"),
                     .view = text_of(entry, "view"),
                     .scene = text_of(entry, "scene"),
                     .points = (int)json_integer_value(json_object_get(entry, "points")),
                     .variants = (int)json_integer_value(json_object_get(entry, "variants")),
                     .optional = json_is_true(json_object_get(entry, "optional"))};
    for (int c = 0; c < rubric->check_count; c++)
        if (strcmp(rubric->checks[c].name, check->name) == 0)
            return json_fields_fail(place, "name", "checks[%d] has this name, too; write another", c);
    rubric->check_count++;
    return rubric_names_task(rubric, place, check->task) && check_scene(place, check->scene) &&
           read_knobs(check, place, json_object_get(entry, "knobs"));
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

static bool read_rubric(Rubric *rubric, const JsonPlace *file, json_t *root) {
    size_t i;
    json_t *entry;
    if (!json_fields_check(file, root, rubric_fields))
        return false;
    rubric->title = text_of(root, "title");
    rubric->pass_mark = json_number_value(json_object_get(root, "pass_mark"));
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
    return true;
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
    if (!ok)
        rubric_destroy(rubric);
    return ok;
}
