#include "changes.h"

#include "check.h"
#include "derive.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static void mix(uint64_t *mark, uint64_t value) {
    *mark = (*mark ^ value) * 0x100000001b3u;
}

uint64_t changes_mark(const Rubric *rubric, const char *folder) {
    uint64_t mark = 0xcbf29ce484222325u;
    for (int i = 0; i < rubric->file_count; i++) {
        char path[FILES_PATH];
        struct stat info = {0};
        files_join(path, folder, rubric->files[i]);
        mix(&mark, stat(path, &info) == 0);
        mix(&mark, (uint64_t)info.st_ino);
        mix(&mark, (uint64_t)info.st_size);
        mix(&mark, (uint64_t)info.st_mtim.tv_sec);
        mix(&mark, (uint64_t)info.st_mtim.tv_nsec);
    }
    return mark;
}

static int line_of(const char *text, const char *at) {
    int line = 1;
    for (; text < at; text++)
        line += *text == '\n';
    return line;
}

bool changes_find_todo(const Rubric *rubric, const char *folder, const char *task, char *place, size_t size) {
    char mark[32];
    bool found = false;
    snprintf(mark, sizeof mark, "TODO(%s)", task);
    for (int i = 0; !found && i < rubric->file_count; i++) {
        char *text = files_read_strange(folder, rubric->files[i], DERIVE_MAX_FILE);
        const char *at = text ? strstr(text, mark) : NULL;
        found = at != NULL;
        if (found)
            snprintf(place, size, "%s:%d", rubric->files[i], line_of(text, at));
        free(text);
    }
    check_clear();
    return found;
}
