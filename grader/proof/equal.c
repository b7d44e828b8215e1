// Reads a lab's equal.json and finds the entry that names a change.
#include "proof/equal.h"

#include "base/files.h"
#include "base/json_fields.h"
#include "base/limits.h"
#include "compile/rubric_names.h"
#include "scene/check.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_ENTRIES = 1000 };

static const JsonField reason_fields[] = {{"why", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_HINT},
                                          {"changes", FIELD_LIST, FIELD_NEEDED, 1, MAX_ENTRIES},
                                          {0}};

static const JsonField change_fields[] = {{"file", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                          {"line", FIELD_LINES, FIELD_NEEDED, 1, RUBRIC_MAX_HINT},
                                          {"from", FIELD_NAME, FIELD_NEEDED, 0, RUBRIC_MAX_HINT},
                                          {"to", FIELD_LIST, FIELD_OPTIONAL, 1, MAX_ENTRIES},
                                          {"nth", FIELD_WHOLE, FIELD_OPTIONAL, 1, MAX_ENTRIES},
                                          {"task", FIELD_NAME, FIELD_OPTIONAL, 1, RUBRIC_MAX_NAME},
                                          {0}};

static const JsonField to_text = {"to", FIELD_NAME, FIELD_NEEDED, 0, RUBRIC_MAX_HINT};

static const char *text_of(json_t *entry, const char *key) {
    return json_string_value(json_object_get(entry, key));
}

static bool read_change(EqualList *list, const Rubric *rubric, const JsonPlace *place, json_t *json,
                        const char *why) {
    size_t i;
    json_t *text;
    if (!json_fields_check(place, json, change_fields))
        return false;
    EqualChange *change = &list->changes[list->count++];
    *change = (EqualChange){.file = text_of(json, "file"),
                            .line = text_of(json, "line"),
                            .from = text_of(json, "from"),
                            .why = why,
                            .task = text_of(json, "task"),
                            .to = json_object_get(json, "to"),
                            .nth = (int)json_integer_value(json_object_get(json, "nth"))};
    if (!change->line)
        return json_fields_fail(place, "line", "it is a list; write one text");
    if (!rubric_names_file(rubric, change->file))
        return json_fields_fail(place, "file",
                                "\"%s\" is not in the list \"files\" of rubric.json; write one of those",
                                change->file);
    json_array_foreach(change->to, i, text) {
        if (!json_fields_fits(place, text, &to_text))
            return false;
    }
    return true;
}

static bool read_reason(EqualList *list, const Rubric *rubric, const JsonPlace *place, json_t *reason) {
    json_t *changes = json_object_get(reason, "changes"), *change;
    size_t i;
    if (!json_fields_check(place, reason, reason_fields))
        return false;
    const size_t room = (size_t)list->count + json_array_size(changes);
    list->changes = realloc(list->changes, room * sizeof *list->changes);
    INVARIANT(list->changes);
    json_array_foreach(changes, i, change) {
        const JsonPlace at = json_fields_enter(place, "changes", i, NULL);
        if (!read_change(list, rubric, &at, change, text_of(reason, "why")))
            return false;
    }
    return true;
}

bool equal_load(EqualList *list, const Rubric *rubric) {
    char path[FILES_PATH];
    json_t *reason;
    size_t i;
    const JsonPlace file = {.folder = rubric->folder, .file = "equal.json"};
    *list = (EqualList){0};
    files_join(path, rubric->folder, file.file);
    if (!files_exists(path))
        return true;
    list->json = json_fields_read(&file, NULL, 0, JSON_ARRAY);
    if (!list->json)
        return false;
    json_array_foreach(list->json, i, reason) {
        const JsonPlace place = json_fields_enter(&file, "", i, NULL);
        if (!read_reason(list, rubric, &place, reason))
            return false;
    }
    return true;
}

void equal_destroy(EqualList *list) {
    json_decref(list->json);
    free(list->changes);
    *list = (EqualList){0};
}

// Does the part begin in the line around `at`? It may go on in the next lines, to tell equal lines apart.
static bool line_has(const char *text, size_t at, const char *part) {
    const char *begin = text + at, *found;
    while (begin > text && begin[-1] != '\n')
        begin--;
    found = strstr(begin, part);
    return found && found < text + at + strcspn(text + at, "\n");
}

static bool names(const EqualChange *change, const Mutant *mutant) {
    size_t i;
    json_t *to;
    if ((change->nth > 0 && change->nth != mutant->nth) ||
        (change->task && strcmp(change->task, mutant->task) != 0))
        return false;
    if (!change->to)
        return true;
    json_array_foreach(change->to, i, to) {
        if (strcmp(json_string_value(to), mutant->replacement) == 0)
            return true;
    }
    return false;
}

const EqualChange *equal_find(EqualList *list, const char *file, const char *text, const Mutant *mutant) {
    for (int i = 0; i < list->count; i++) {
        EqualChange *change = &list->changes[i];
        if (strcmp(change->file, file) == 0 && strcmp(change->from, mutant->before) == 0 &&
            line_has(text, mutant->begin, change->line) && names(change, mutant)) {
            change->matched++;
            return change;
        }
    }
    return NULL;
}
