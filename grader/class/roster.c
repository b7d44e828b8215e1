#include "class/roster.h"

#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

static bool is_archive(const char *name) {
    static const char *const ends[] = {".zip", ".tar.gz", ".tgz"};
    size_t length = strlen(name);
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++)
        if (length > strlen(ends[i]) && strcasecmp(name + length - strlen(ends[i]), ends[i]) == 0)
            return true;
    return false;
}

static void *grow(void *list, int count, size_t size) {
    bool full = (count & (count - 1)) == 0; // room is always a power of two
    void *grown = full ? realloc(list, size * (size_t)(count ? 2 * count : 1)) : list;
    INVARIANT(grown);
    return grown;
}

static void add(const char *name, void *context) {
    Roll *roll = context;
    char path[FILES_PATH];
    struct stat info;
    files_join(path, roll->folder, name);
    bool known = lstat(path, &info) == 0, archive = known && S_ISREG(info.st_mode) && is_archive(name);
    if (name[0] == '.' || (!archive && !(known && S_ISDIR(info.st_mode)))) {
        roll->ignored = grow(roll->ignored, roll->ignored_count, sizeof *roll->ignored);
        roll->ignored[roll->ignored_count++] = escape_name(name);
        return;
    }
    roll->entries = grow(roll->entries, roll->count, sizeof *roll->entries);
    Entry *entry = &roll->entries[roll->count++];
    *entry = (Entry){.name = strdup(name), .shown = escape_name(name), .archive = archive};
    INVARIANT(entry->name);
    escape_file_name(entry->file, name);
}

// A hash of 64 bits can be made to collide by who chooses the names; then nothing is graded.
static bool files_differ(const Roll *roll) {
    for (int i = 0; i < roll->count; i++)
        for (int j = 0; j < i; j++)
            if (strcmp(roll->entries[i].file, roll->entries[j].file) == 0)
                return check_fail("the names \"%s\" and \"%s\" have one hash: rename one of them",
                                  roll->entries[i].shown, roll->entries[j].shown);
    return true;
}

bool roll_read(Roll *roll, const char *folder) {
    *roll = (Roll){0};
    if (strlen(folder) > FILES_PATH - 300)
        return check_fail("the path of the class's folder is too long");
    snprintf(roll->folder, sizeof roll->folder, "%s", folder);
    return files_list(folder, add, roll) &&
           (roll->count > 0 || check_fail("%s holds no folder and no archive (.zip, .tar.gz)", folder)) &&
           files_differ(roll);
}

void roll_destroy(Roll *roll) {
    for (int i = 0; i < roll->count; i++) {
        free(roll->entries[i].name);
        free(roll->entries[i].shown);
    }
    for (int i = 0; i < roll->ignored_count; i++)
        free(roll->ignored[i]);
    free(roll->entries);
    free(roll->ignored);
    *roll = (Roll){0};
}

int roll_find(const Roll *roll, const char *name) {
    for (int i = 0; i < roll->count; i++) {
        const Entry *entry = &roll->entries[i];
        if (strcmp(entry->name, name) == 0 || strcmp(entry->shown, name) == 0 ||
            strcmp(entry->file, name) == 0)
            return i;
    }
    char *shown = escape_name(name);
    check_fail("%s holds no submission \"%s\"", roll->folder, shown);
    free(shown);
    return -1;
}
