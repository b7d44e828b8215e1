#include "compile/afterword.h"

#include "base/files.h"

static const JsonField fields[] = {
    {"idea", FIELD_NAME, FIELD_NEEDED, 1, AFTERWORD_MAX_TEXT},
    {"questions", FIELD_LIST, FIELD_NEEDED, AFTERWORD_QUESTIONS, AFTERWORD_QUESTIONS},
    {"another way", FIELD_NAME, FIELD_NEEDED, 1, AFTERWORD_MAX_TEXT},
    {"try", FIELD_LIST, FIELD_NEEDED, 1, AFTERWORD_MAX_PARTS},
    {0}};

static const JsonField answer_fields[] = {{"about", FIELD_NAME, FIELD_NEEDED, 1, AFTERWORD_MAX_ABOUT},
                                          {"answer", FIELD_LIST, FIELD_NEEDED, 1, AFTERWORD_MAX_PARTS},
                                          {0}};

static const JsonField part = {"", FIELD_NAME, FIELD_NEEDED, 1, AFTERWORD_MAX_TEXT};

static bool read_list(const JsonPlace *outer, const json_t *object, const char *key, const char **parts,
                      int *count) {
    size_t i;
    json_t *entry;
    json_array_foreach(json_object_get(object, key), i, entry) {
        const JsonPlace place = json_fields_enter(outer, key, i, NULL);
        if (!json_fields_fits(&place, entry, &part))
            return false;
        parts[(*count)++] = json_string_value(entry);
    }
    return true;
}

static bool read_answers(const JsonPlace *file, const json_t *root, AfterwordAnswer *answers) {
    size_t i;
    json_t *entry;
    json_array_foreach(json_object_get(root, "questions"), i, entry) {
        const JsonPlace place = json_fields_enter(file, "questions", i, NULL);
        AfterwordAnswer *answer = &answers[i];
        if (!json_fields_check(&place, entry, answer_fields) ||
            !read_list(&place, entry, "answer", answer->parts, &answer->part_count))
            return false;
        answer->about = json_string_value(json_object_get(entry, "about"));
    }
    return true;
}

bool afterword_load(Afterword *afterword, const Rubric *rubric) {
    const JsonPlace file = {.folder = rubric->folder, .file = "afterword.json"};
    char path[FILES_PATH];
    *afterword = (Afterword){0};
    files_join(path, rubric->folder, file.file);
    if (!files_exists(path))
        return true;
    json_t *root = afterword->json = json_fields_read(&file, NULL, 0, JSON_OBJECT);
    if (root && json_fields_check(&file, root, fields) && read_answers(&file, root, afterword->answers) &&
        read_list(&file, root, "try", afterword->tries, &afterword->try_count)) {
        afterword->idea = json_string_value(json_object_get(root, "idea"));
        afterword->other_way = json_string_value(json_object_get(root, "another way"));
        return true;
    }
    afterword_destroy(afterword);
    return false;
}

void afterword_destroy(Afterword *afterword) {
    json_decref(afterword->json);
    *afterword = (Afterword){0};
}
