#include "diagnose/open_tasks.h"

#include "base/files.h"
#include "compile/lab_folder.h"
#include "compile/tokens.h"
#include "exam/exam_file.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS_AFTER = 3 }; // that a task in its place would push away

// Do the same words follow behind the lines of the two marks?
static bool same_after(const char *a, const char *b) {
    a += strcspn(a, "\n");
    b += strcspn(b, "\n");
    for (int i = 0; i < WORDS_AFTER; i++) {
        const Token x = tokens_next(&a), y = tokens_next(&b);
        if (x.kind != y.kind || x.length != y.length || memcmp(x.text, y.text, x.length) != 0)
            return false;
        if (x.kind == TOKEN_END)
            return true;
    }
    return true;
}

static bool stands_as_handed_out(const char *mark, const char *at, const char *skeleton) {
    for (const char *ours = strstr(skeleton, mark); ours; ours = strstr(ours + 1, mark))
        if (same_after(at, ours))
            return true;
    return false;
}

static void find_in(OpenTasks *tasks, const Rubric *rubric, const char *text, const char *skeleton) {
    for (int t = 0; t < rubric->hint_count && t < EXAM_MAX_TASKS; t++) {
        char mark[32];
        snprintf(mark, sizeof mark, "TODO(%s)", rubric->hints[t].task);
        for (const char *at = strstr(text, mark); at; at = strstr(at + 1, mark)) {
            tasks->marked[t] = true;
            tasks->open[t] = tasks->open[t] || stands_as_handed_out(mark, at, skeleton);
        }
    }
}

void open_tasks_find(OpenTasks *tasks, const Rubric *rubric, const char *folder) {
    *tasks = (OpenTasks){0};
    for (int i = 0; i < rubric->file_count; i++) {
        char path[FILES_PATH];
        files_join(path, folder, rubric->files[i]);
        char *text = files_read(path, DERIVE_MAX_FILE), *skeleton = exam_file_skeleton(rubric, i);
        if (text && skeleton)
            find_in(tasks, rubric, text, skeleton);
        free(text);
        free(skeleton);
    }
    check_clear();
}
