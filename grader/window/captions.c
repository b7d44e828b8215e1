#include "window/captions.h"

#include "base/files.h"
#include "protocol/protocol.h"

#include <string.h>

static const JsonField caption = {"", FIELD_NAME, FIELD_NEEDED, 1, PROTOCOL_LINE - 1};

bool captions_load(Captions *captions, const Rubric *rubric) {
    const JsonPlace file = {.folder = rubric->folder, .file = "captions.json"};
    char path[FILES_PATH] = "";
    const char *stage;
    json_t *text;
    *captions = (Captions){0};
    if (rubric->folder)
        files_join(path, rubric->folder, file.file);
    if (!files_exists(path))
        return true;
    captions->json = json_fields_read(&file, NULL, 0, JSON_OBJECT);
    bool ok = captions->json != NULL;
    json_object_foreach(captions->json, stage, text) {
        const JsonPlace place = json_fields_enter(&file, "", 0, stage);
        ok = ok && json_fields_fits(&place, text, &caption);
    }
    if (!ok)
        captions_destroy(captions);
    return ok;
}

void captions_destroy(Captions *captions) {
    json_decref(captions->json);
    *captions = (Captions){0};
}

const char *captions_find(const Captions *captions, const char *view) {
    const char *text = json_string_value(json_object_get(captions->json, view));
    if (text)
        return text;
    return strcmp(view, VIEW_VISIBILITY) == 0 ? "white is lit, black is in the shadow" : "";
}
