#include "compile/todo.h"

#include "base/files.h"
#include "base/find_file.h"
#include "compile/lab_folder.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int line_of(const char *text, const char *at) {
    int line = 1;
    for (; text < at; text++)
        line += *text == '\n';
    return line;
}

bool todo_find(const Rubric *rubric, const char *folder, const char *task, char *place, size_t size) {
    char mark[32];
    bool found = false;
    snprintf(mark, sizeof mark, "TODO(%s)", task);
    for (int i = 0; !found && i < rubric->file_count; i++) {
        char renamed[FIND_FILE_NAME];
        const char *name = find_file(renamed, folder, rubric->files[i]) ? renamed : rubric->files[i];
        char *text = files_read_untrusted(folder, name, DERIVE_MAX_FILE);
        const char *at = text ? strstr(text, mark) : NULL;
        found = at != NULL;
        if (found)
            snprintf(place, size, "%s:%d", name, line_of(text, at));
        free(text);
    }
    check_clear();
    return found;
}
