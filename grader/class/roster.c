#include "class/roster.h"

#include "intake/archive.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static void *grow(void *list, int count, size_t size) {
    bool full = (count & (count - 1)) == 0; // room is always a power of two
    void *grown = full ? realloc(list, size * (size_t)(count ? 2 * count : 1)) : list;
    INVARIANT(grown);
    return grown;
}

static void add(const char *name, void *context) {
    Roster *roster = context;
    char path[FILES_PATH];
    struct stat info;
    files_join(path, roster->folder, name);
    bool known = lstat(path, &info) == 0, archive = known && S_ISREG(info.st_mode) && archive_is_name(name);
    if (name[0] == '.' || (!archive && !(known && S_ISDIR(info.st_mode)))) {
        roster->ignored = grow(roster->ignored, roster->ignored_count, sizeof *roster->ignored);
        roster->ignored[roster->ignored_count++] = printable_name(name);
        return;
    }
    roster->entries = grow(roster->entries, roster->count, sizeof *roster->entries);
    RosterEntry *entry = &roster->entries[roster->count++];
    *entry = (RosterEntry){.name = strdup(name), .shown = printable_name(name), .archive = archive};
    INVARIANT(entry->name);
    printable_file_name(entry->file, name);
}

// A hash of 64 bits can be made to collide by who chooses the names; then nothing is graded.
static bool files_differ(const Roster *roster) {
    for (int i = 0; i < roster->count; i++)
        for (int j = 0; j < i; j++)
            if (strcmp(roster->entries[i].file, roster->entries[j].file) == 0)
                return check_fail("the names \"%s\" and \"%s\" have one hash: rename one of them",
                                  roster->entries[i].shown, roster->entries[j].shown);
    return true;
}

bool roster_read(Roster *roster, const char *folder) {
    *roster = (Roster){0};
    if (strlen(folder) > FILES_PATH - 300)
        return check_fail("the path of the class's folder is too long");
    snprintf(roster->folder, sizeof roster->folder, "%s", folder);
    return files_list(folder, add, roster) &&
           (roster->count > 0 || check_fail("%s holds no folder and no archive (.zip, .tar.gz)", folder)) &&
           files_differ(roster);
}

void roster_destroy(Roster *roster) {
    for (int i = 0; i < roster->count; i++) {
        free(roster->entries[i].name);
        free(roster->entries[i].shown);
    }
    for (int i = 0; i < roster->ignored_count; i++)
        free(roster->ignored[i]);
    free(roster->entries);
    free(roster->ignored);
    *roster = (Roster){0};
}

int roster_find(const Roster *roster, const char *name) {
    for (int i = 0; i < roster->count; i++) {
        const RosterEntry *entry = &roster->entries[i];
        if (strcmp(entry->name, name) == 0 || strcmp(entry->shown, name) == 0 ||
            strcmp(entry->file, name) == 0)
            return i;
    }
    char *shown = printable_name(name);
    check_fail("%s holds no submission \"%s\"", roster->folder, shown);
    free(shown);
    return -1;
}
