#include "grade/found_lab.h"

#include "base/find_file.h"
#include "exam/handed_out.h"
#include "predict/prediction_file.h"
#include "scene/check.h"

#include <stdio.h>
#include <string.h>

enum { MOST_IGNORED = 8 };

typedef struct FolderFiles {
    const Rubric *rubric;
    char taken[RUBRIC_MAX_FILES][FIND_FILE_NAME]; // under which name each file of the rubric lies there
    char predictions[FIND_FILE_NAME];             // and what was predicted
    void (*say)(const char *text, void *context);
    void *context;
    int ignored;
} FolderFiles;

static void find_files(FolderFiles *files, const char *folder) {
    for (int i = 0; i < files->rubric->file_count; i++)
        if (!find_file(files->taken[i], folder, files->rubric->files[i]))
            files->taken[i][0] = '\0';
    if (!find_file(files->predictions, folder, PREDICTION_FILE))
        files->predictions[0] = '\0';
}

// Is it taken for a file of the lab? Then, under another name, that is said.
static bool is_taken(const FolderFiles *files, const char *name) {
    char text[600];
    for (int i = 0; i < files->rubric->file_count; i++) {
        const char *wanted = files->rubric->files[i];
        if (strcmp(files->taken[i], name) != 0)
            continue;
        snprintf(text, sizeof text, "%.255s is taken for %.255s", name, wanted);
        if (strcmp(wanted, name) != 0)
            files->say(text, files->context);
        return true;
    }
    return false;
}

// What an editor leaves beside a file that it saves: lab.c~, #lab.c#, .lab.c.swp. Also what a system hides.
static bool is_aside(const char *name) {
    const char last = name[0] ? name[strlen(name) - 1] : '\0';
    return name[0] == '.' || last == '~' || (name[0] == '#' && last == '#');
}

static void look(const char *name, void *context) {
    FolderFiles *files = context;
    char text[400];
    if (is_taken(files, name) || strcmp(files->predictions, name) == 0 || is_aside(name) ||
        handed_out_has(files->rubric, name) || ++files->ignored > MOST_IGNORED)
        return;
    snprintf(text, sizeof text, "ignored: %.300s (not a file of this lab)", name);
    files->say(text, files->context);
}

bool found_lab_files(const Rubric *rubric, const char *folder, void (*say)(const char *text, void *context),
                     void *context) {
    FolderFiles files = {.rubric = rubric, .say = say, .context = context};
    find_files(&files, folder);
    check_clear();
    return files_check_folder(folder) && files_list(folder, look, &files);
}

void found_lab_missing(char *text, size_t size, const Submission *submission, const Rubric *rubric) {
    const char *name = strrchr(rubric->folder, '/') + 1;
    if (submission_nameless(submission))
        snprintf(text, size, "there is a lab.c, but nothing tells of which lab: put it into %s/", name);
    else if (submission->why[0])
        snprintf(text, size, "not handed in: there is no folder %s, and an archive inside is bad: %s", name,
                 submission->why);
    else
        snprintf(text, size, "not handed in: there is no folder %s (a link is none)", name);
}
