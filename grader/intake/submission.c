#include "intake/submission.h"

#include "scene/check.h"
#include "base/places.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_WRAPPERS = 3 };

typedef struct Content {
    int entries, labs;
    char only[256];
} Content;

static void look(const char *name, void *context) {
    Content *content = context;
    if (name[0] == '.' || strcmp(name, "__MACOSX") == 0)
        return;
    content->entries++;
    content->labs += places_is_lab_name(name);
    snprintf(content->only, sizeof content->only, "%s", name);
}

// Steps into the only folder in `folder`. False when it holds something else.
static bool unwrap(char folder[FILES_PATH]) {
    Content content = {0};
    char inner[FILES_PATH];
    if (strlen(folder) + sizeof content.only + 2 > FILES_PATH || !files_list(folder, look, &content) ||
        content.entries != 1 || content.labs > 0)
        return false;
    files_join(inner, folder, content.only);
    if (!files_is_folder(inner))
        return false;
    memcpy(folder, inner, FILES_PATH);
    return true;
}

static void name_single(Submission *submission) {
    const char *name = strrchr(submission->folder, '/') + 1;
    if (places_is_lab_name(name))
        snprintf(submission->single_id, sizeof submission->single_id, "%.2s", name);
}

bool submission_open(Submission *submission, const char *folder) {
    char path[FILES_PATH];
    *submission = (Submission){0};
    // The path may hold links: it is the caller's. What lies in the folder is what was handed in.
    if (!realpath(folder, submission->folder) || !files_is_folder(submission->folder) ||
        strlen(submission->folder) >= FILES_PATH - 300)
        return check_fail("%s is not a folder", folder);
    for (int i = 0; i < MAX_WRAPPERS && unwrap(submission->folder); i++)
        continue;
    check_clear();
    files_join(path, submission->folder, "lab.c");
    submission->single = files_exists(path);
    if (submission->single)
        name_single(submission);
    return true;
}

// The folder of the name that it has in labs/, else the first "03-...".
static bool find_lab(char folder[FILES_PATH], const char *parent, const char *id) {
    char ours[FILES_PATH];
    if (places_find_lab(ours, id)) {
        files_join(folder, parent, strrchr(ours, '/') + 1);
        if (files_is_folder(folder))
            return true;
    }
    return places_find_lab_in(folder, parent, id) && files_is_folder(folder);
}

bool submission_find(const Submission *submission, const char *id, char folder[FILES_PATH]) {
    if (!submission->single)
        return find_lab(folder, submission->folder, id);
    memcpy(folder, submission->folder, FILES_PATH);
    return strcmp(submission->single_id, id) == 0;
}
