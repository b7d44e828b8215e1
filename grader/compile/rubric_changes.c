// Reads the lists of edits (mistakes, alternatives) and of hints, entry by entry.
#include "compile/rubric_changes.h"

#include "compile/rubric_names.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// In the student's kit neither has edits.
static const JsonField mistake_fields[] = {{"name", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                           {"task", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                           {"hint", FIELD_LINES, FIELD_NEEDED, 1, RUBRIC_MAX_HINT},
                                           {"edits", FIELD_LIST, FIELD_OPTIONAL, 1, RUBRIC_MAX_EDITS},
                                           {0}};

static const JsonField alternative_fields[] = {{"name", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                               {"edits", FIELD_LIST, FIELD_OPTIONAL, 1, RUBRIC_MAX_EDITS},
                                               {0}};

static const JsonField edit_fields[] = {{"file", FIELD_NAME, FIELD_NEEDED, 1, RUBRIC_MAX_NAME},
                                        {"find", FIELD_LINES, FIELD_NEEDED, 1, RUBRIC_MAX_EDIT},
                                        {"replace", FIELD_LINES, FIELD_NEEDED, 0, RUBRIC_MAX_EDIT},
                                        {0}};

static const JsonField hint_list = {"", FIELD_LIST, FIELD_NEEDED, 1, RUBRIC_MAX_HINTS};
static const JsonField hint_text = {"", FIELD_LINES, FIELD_NEEDED, 1, RUBRIC_MAX_HINT};

static const char *text_of(const json_t *object, const char *key) {
    return json_string_value(json_object_get(object, key));
}

static const char *lines_of(const Rubric *rubric, const json_t *object, const char *key) {
    return json_fields_join(json_array_get(rubric->json, 0), json_object_get(object, key));
}

static bool read_edit(const Rubric *rubric, const JsonPlace *place, const json_t *entry, Edit *edit) {
    if (!json_fields_check(place, entry, edit_fields))
        return false;
    *edit = (Edit){.file = text_of(entry, "file"),
                   .find = lines_of(rubric, entry, "find"),
                   .replace = lines_of(rubric, entry, "replace")};
    return rubric_names_file(rubric, edit->file) ||
           json_fields_fail(place, "file",
                            "\"%s\" is not in the list \"files\" of rubric.json; write one of those",
                            edit->file);
}

static bool read_change(const Rubric *rubric, const JsonPlace *place, json_t *entry, Change *change) {
    size_t i;
    json_t *edit;
    change->name = text_of(entry, "name");
    change->task = text_of(entry, "task");
    change->hint = json_object_get(entry, "hint") ? lines_of(rubric, entry, "hint") : NULL;
    if (change->task &&
        (!rubric_names_task(rubric, place, change->task) || !rubric_names_asked(rubric, place, change->task)))
        return false;
    json_array_foreach(json_object_get(entry, "edits"), i, edit) {
        const JsonPlace at = json_fields_enter(place, "edits", i, NULL);
        if (!read_edit(rubric, &at, edit, &change->edits[change->edit_count++]))
            return false;
    }
    return true;
}

typedef struct Changes {
    const JsonField list, *fields; // of the whole list and of an entry
    Change **changes;
    int *count;
} Changes;

static bool read_changes(const Rubric *rubric, const JsonPlace *file, json_t *root, const Changes *into) {
    size_t i;
    json_t *entry;
    if (!json_fields_fits(file, root, &into->list))
        return false;
    Change *changes = *into->changes = calloc(json_array_size(root) + 1, sizeof *changes);
    INVARIANT(changes);
    json_array_foreach(root, i, entry) {
        const JsonPlace place = json_fields_enter(file, "", i, text_of(entry, "name"));
        if (!json_fields_check(&place, entry, into->fields))
            return false;
        for (size_t other = 0; other < i; other++)
            if (strcmp(changes[other].name, text_of(entry, "name")) == 0)
                return json_fields_fail(&place, "name", "[%zu] has this name, too; write another", other);
        if (!read_change(rubric, &place, entry, &changes[i]))
            return false;
        (*into->count)++;
    }
    return true;
}

bool rubric_changes_mistakes(Rubric *rubric, const JsonPlace *file, json_t *root) {
    const Changes into = {{"", FIELD_LIST, FIELD_NEEDED, 0, EXAM_MAX_MISTAKES},
                          mistake_fields,
                          &rubric->mistakes,
                          &rubric->mistake_count};
    return read_changes(rubric, file, root, &into);
}

bool rubric_changes_alternatives(Rubric *rubric, const JsonPlace *file, json_t *root) {
    const Changes into = {{"", FIELD_LIST, FIELD_NEEDED, 0, EXAM_MAX_ALTERNATIVES},
                          alternative_fields,
                          &rubric->alternatives,
                          &rubric->alternative_count};
    return read_changes(rubric, file, root, &into);
}

static bool read_hint(const Rubric *rubric, const JsonPlace *file, json_t *texts, Hint *hint) {
    size_t i;
    json_t *text;
    JsonField list = hint_list;
    list.key = hint->task;
    if (!rubric_names_task(rubric, file, hint->task) || !rubric_names_asked(rubric, file, hint->task) ||
        !json_fields_fits(file, texts, &list))
        return false;
    hint->texts = calloc(json_array_size(texts), sizeof *hint->texts);
    INVARIANT(hint->texts);
    json_array_foreach(texts, i, text) {
        char name[RUBRIC_MAX_NAME];
        snprintf(name, sizeof name, "\"%s\"", hint->task);
        const JsonPlace place = json_fields_enter(file, name, i, NULL);
        if (!json_fields_fits(&place, text, &hint_text))
            return false;
        hint->texts[hint->count++] = json_fields_join(json_array_get(rubric->json, 0), text);
    }
    return true;
}

bool rubric_changes_hints(Rubric *rubric, const JsonPlace *file, json_t *root) {
    const char *task;
    json_t *texts;
    rubric->hints = calloc(json_object_size(root) + 1, sizeof *rubric->hints);
    INVARIANT(rubric->hints);
    json_object_foreach(root, task, texts) {
        rubric->hints[rubric->hint_count] = (Hint){.task = task};
        if (!read_hint(rubric, file, texts, &rubric->hints[rubric->hint_count++]))
            return false;
    }
    return true;
}
