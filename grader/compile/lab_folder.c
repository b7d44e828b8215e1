// Makes a lab's folder: from our annotated source with a choice of tasks and edits (kept in build/cache by a
// hash), or from a submission's files.
#include "compile/lab_folder.h"

#include "scene/check.h"
#include "compile/given.h"
#include "base/hash.h"
#include "base/find_file.h"
#include "base/places.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Texts {
    char *of[RUBRIC_MAX_FILES]; // in the order of rubric->files
} Texts;

static void free_texts(Texts *texts) {
    for (int i = 0; i < RUBRIC_MAX_FILES; i++)
        free(texts->of[i]);
}

// Replaces *text by `changed`, which may be NULL after a failure.
static bool replace_text(char **text, char *changed) {
    free(*text);
    *text = changed;
    return changed != NULL;
}

// False with a message that names the mistake and the edit.
static bool apply_edit(char **text, const Rubric *rubric, const Change *change, int e) {
    char reason[1024];
    check_clear();
    if (replace_text(text, task_blocks_edit(*text, &change->edits[e])))
        return true;
    snprintf(reason, sizeof reason, "%s", check_message());
    check_clear();
    const JsonPlace outer = rubric_change_place(rubric, change);
    const JsonPlace place = json_fields_enter(&outer, "edits", (size_t)e, NULL);
    return json_fields_fail(&place, "find", "%s", reason);
}

static bool apply_edits(Texts *texts, const Rubric *rubric, const Change *change) {
    for (int e = 0; change && e < change->edit_count; e++) {
        int i = 0;
        while (i < rubric->file_count && strcmp(rubric->files[i], change->edits[e].file) != 0)
            i++;
        INVARIANT(i < rubric->file_count); // rubric_load has looked
        if (!apply_edit(&texts->of[i], rubric, change, e))
            return false;
    }
    return true;
}

char *lab_folder_source(const Rubric *rubric, int i, Solved solved) {
    char path[FILES_PATH];
    files_join(path, rubric->folder, rubric->files[i]);
    char *text = files_read(path, DERIVE_MAX_FILE);
    if (text)
        replace_text(&text, task_blocks_select(rubric->files[i], text, solved, true));
    return text;
}

static bool read_ours(Texts *texts, const Rubric *rubric, Solved solved) {
    for (int i = 0; i < rubric->file_count; i++)
        if (!(texts->of[i] = lab_folder_source(rubric, i, solved)))
            return false;
    return true;
}

bool lab_folder_can_change(const Rubric *rubric, const Change *change) {
    Texts texts = {0};
    const bool ok =
        read_ours(&texts, rubric, (Solved){SOLVED_ALL, NULL}) && apply_edits(&texts, rubric, change);
    free_texts(&texts);
    return ok;
}

// The worker stands for common/: it is linked again when a header or a function there changes.
static uint64_t hash_texts(const Texts *texts, const Rubric *rubric) {
    char worker[FILES_PATH];
    struct stat info = {0};
    places_build_path(worker, "worker");
    stat(worker, &info);
    uint64_t hash = hash_bytes(HASH_START, &info.st_mtim, sizeof info.st_mtim);
    hash = hash_bytes(hash, rubric->id, sizeof rubric->id);
    for (int i = 0; i < rubric->file_count; i++)
        hash = hash_bytes(hash, texts->of[i], strlen(texts->of[i]) + 1);
    return hash;
}

static bool write_texts(const char *folder, const Rubric *rubric, const Texts *texts) {
    for (int i = 0; i < rubric->file_count; i++) {
        char path[FILES_PATH];
        files_join(path, folder, rubric->files[i]);
        if (!files_write(path, texts->of[i]))
            return false;
    }
    return true;
}

// Builds aside and renames, so that a folder in the cache is always whole, also with several graders at once.
static bool build_in_cache(const char *folder, const Rubric *rubric, const Texts *texts,
                           const Change *change) {
    char aside[FILES_PATH], log[COMPILE_LOG] = "";
    snprintf(aside, sizeof aside, "%.4000s.%ld/", folder, (long)getpid());
    if (!files_make_folder(aside) || !write_texts(aside, rubric, texts) ||
        !given_place(aside, rubric->id, NULL))
        return false;
    if (!compiler_build(aside, NULL, log)) {
        files_remove(aside);
        if (!log[0]) // the compiler did not start
            return false;
        check_clear();
        return check_fail("our own lab %s does not compile%s%s: %s", rubric->id, change ? " with " : "",
                          change ? change->name : "", log);
    }
    aside[strlen(aside) - 1] = '\0';
    if (rename(aside, folder) != 0)
        files_remove(aside);
    return true;
}

bool lab_folder_ours(char folder[FILES_PATH], const Rubric *rubric, Solved solved, const Change *change) {
    Texts texts = {0};
    bool ok = read_ours(&texts, rubric, solved) && apply_edits(&texts, rubric, change);
    if (ok) {
        char name[64];
        snprintf(name, sizeof name, "cache/%s-%016llx", rubric->id,
                 (unsigned long long)hash_texts(&texts, rubric));
        places_build_path(folder, name);
        ok = files_exists(folder) || build_in_cache(folder, rubric, &texts, change);
    }
    free_texts(&texts);
    return ok;
}

static bool is_same_file(const char *folder, const char *earlier, const char *name) {
    char path[FILES_PATH], old_path[FILES_PATH];
    files_join(path, folder, name);
    files_join(old_path, earlier, name);
    char *text = files_read(path, DERIVE_MAX_FILE), *old = files_read(old_path, DERIVE_MAX_FILE);
    const bool same = text && old && strcmp(text, old) == 0;
    free(text);
    free(old);
    return same;
}

bool lab_folder_is_c(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot && (strcmp(dot, ".c") == 0 || strcmp(dot, ".h") == 0);
}

// Takes lab.so from an earlier folder; false when a file that goes into it is not the same there.
static bool take_library(const char *folder, const char *earlier, const Rubric *rubric) {
    char path[FILES_PATH], old_path[FILES_PATH];
    for (int i = 0; i < rubric->file_count; i++)
        if (lab_folder_is_c(rubric->files[i]) && !is_same_file(folder, earlier, rubric->files[i]))
            return false;
    files_join(path, folder, "lab.so");
    files_join(old_path, earlier, "lab.so");
    return link(old_path, path) == 0;
}

bool lab_folder_again(const char *folder, const char *earlier, const Rubric *rubric, const char *submission,
                      const Jail *jail, char log[COMPILE_LOG]) {
    Texts texts = {0};
    bool ok = true;
    log[0] = '\0';
    for (int i = 0; ok && i < rubric->file_count; i++) {
        texts.of[i] = find_file_read(submission, rubric->files[i], DERIVE_MAX_FILE);
        ok = texts.of[i] && replace_text(&texts.of[i], task_blocks_select(rubric->files[i], texts.of[i],
                                                                          (Solved){SOLVED_ALL, NULL}, true));
    }
    ok = ok && write_texts(folder, rubric, &texts) && given_place(folder, rubric->id, jail) &&
         ((earlier && take_library(folder, earlier, rubric)) || compiler_build(folder, jail, log));
    free_texts(&texts);
    return ok;
}

bool lab_folder_submission(const char *folder, const Rubric *rubric, const char *submission, const Jail *jail,
                           char log[COMPILE_LOG]) {
    return lab_folder_again(folder, NULL, rubric, submission, jail, log);
}

bool lab_folder_mixed(const char *folder, const char *earlier, const Rubric *rubric, char *const *texts,
                      const Jail *jail) {
    static _Thread_local char log[COMPILE_LOG];
    Texts mixed = {0};
    char source[FILES_PATH];
    memcpy(mixed.of, texts, sizeof *texts * (size_t)rubric->file_count);
    bool ok = write_texts(folder, rubric, &mixed) && given_place(folder, rubric->id, jail) &&
              (take_library(folder, earlier, rubric) || compiler_build(folder, jail, log));
    files_join(source, folder, "lab.c");
    unlink(source);
    check_clear();
    return ok;
}
