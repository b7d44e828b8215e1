#include "proof/equal.h"

#include "base/files.h"
#include "scene/check.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static const char *text_of(json_t *entry, const char *key) {
    return json_string_value(json_object_get(entry, key));
}

static bool are_texts(json_t *list) {
    size_t i;
    json_t *text;
    json_array_foreach(list, i, text) {
        if (!json_is_string(text))
            return false;
    }
    return json_array_size(list) > 0;
}

static bool is_file(const Rubric *rubric, const char *name) {
    for (int i = 0; name && i < rubric->file_count; i++)
        if (strcmp(rubric->files[i], name) == 0)
            return true;
    return false;
}

static bool read_change(EqualList *list, const Rubric *rubric, json_t *json, const char *why) {
    EqualChange *change = &list->changes[list->count++];
    *change = (EqualChange){text_of(json, "file"),
                            text_of(json, "line"),
                            text_of(json, "from"),
                            why,
                            json_object_get(json, "to"),
                            (int)json_integer_value(json_object_get(json, "nth")),
                            0};
    if (!is_file(rubric, change->file) || !change->line || !change->from)
        return check_fail("%s/equal.json: change %d needs a \"file\" of the lab, \"line\" and \"from\"",
                          rubric->folder, list->count);
    return !change->to || are_texts(change->to) ||
           check_fail("%s/equal.json: change %d: \"to\" is a list of texts", rubric->folder, list->count);
}

static bool read_reason(EqualList *list, const Rubric *rubric, json_t *reason) {
    json_t *changes = json_object_get(reason, "changes"), *change;
    const char *why = text_of(reason, "why");
    size_t i;
    if (!why || !why[0] || json_array_size(changes) == 0)
        return check_fail("%s/equal.json: each entry needs \"why\" and \"changes\"", rubric->folder);
    const size_t room = (size_t)list->count + json_array_size(changes);
    list->changes = realloc(list->changes, room * sizeof *list->changes);
    INVARIANT(list->changes);
    json_array_foreach(changes, i, change) {
        if (!read_change(list, rubric, change, why))
            return false;
    }
    return true;
}

bool equal_load(EqualList *list, const Rubric *rubric) {
    char path[FILES_PATH];
    json_error_t error;
    json_t *reason;
    size_t i;
    *list = (EqualList){0};
    files_join(path, rubric->folder, "equal.json");
    if (!files_exists(path))
        return true;
    list->json = json_load_file(path, 0, &error);
    if (!list->json)
        return check_fail("%s:%d: %s", path, error.line, error.text);
    json_array_foreach(list->json, i, reason) {
        if (!read_reason(list, rubric, reason))
            return false;
    }
    return json_is_array(list->json) || check_fail("%s:1: expected a list [ ]", path);
}

void equal_destroy(EqualList *list) {
    json_decref(list->json);
    free(list->changes);
    *list = (EqualList){0};
}

static bool line_has(const char *text, size_t at, const char *part) {
    const char *begin = text + at, *found;
    while (begin > text && begin[-1] != '\n')
        begin--;
    found = strstr(begin, part);
    return found && found + strlen(part) <= text + at + strcspn(text + at, "\n");
}

static bool names(const EqualChange *change, const Mutant *mutant) {
    size_t i;
    json_t *to;
    if (change->nth > 0 && change->nth != mutant->nth)
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
