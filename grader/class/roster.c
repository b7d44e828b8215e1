// Reads the names, asks hand_in_name.h what they tell, and makes one entry of what is one student's.
#include "class/roster.h"

#include "class/hand_in_name.h"
#include "intake/archive.h"
#include "jail/extract_protocol.h"
#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// A name in the class's folder.
typedef struct HandIn {
    char *name;
    bool loose; // a file, not an archive
    HandInName told;
    struct timespec changed;
} HandIn;

typedef struct Reading {
    Roster *roster;
    HandIn *sources;
    int count;
    struct stat output; // its device and inode; 0: none
} Reading;

static void *grow(void *list, int count, size_t size) {
    bool full = (count & (count - 1)) == 0; // room is always a power of two
    void *grown = full ? realloc(list, size * (size_t)(count ? 2 * count : 1)) : list;
    INVARIANT(grown);
    return grown;
}

static void ignore(Roster *roster, const char *name, const char *why) {
    roster->ignored = grow(roster->ignored, roster->ignored_count, sizeof *roster->ignored);
    roster->ignored[roster->ignored_count++] = (RosterIgnored){printable_name(name), why};
}

// Only a learning system's name tells whose a loose file is.
static bool is_loose(const HandIn *source, const struct stat *info) {
    return S_ISREG(info->st_mode) && source->told.id[0] && source->told.file[0] &&
           extract_wants_file(source->told.file);
}

static void add_source(const char *name, void *context) {
    Reading *reading = context;
    HandIn source = {0};
    char path[FILES_PATH];
    struct stat info;
    files_join(path, reading->roster->folder, name);
    hand_in_name_read(&source.told, name);
    if (name[0] == '.' || lstat(path, &info) != 0)
        ignore(reading->roster, name, "is hidden");
    else if (reading->output.st_ino && info.st_ino == reading->output.st_ino &&
             info.st_dev == reading->output.st_dev)
        ignore(reading->roster, name, "is the output of the class run");
    else if (!S_ISDIR(info.st_mode) && !(S_ISREG(info.st_mode) && archive_is_name(name)) &&
             !is_loose(&source, &info))
        ignore(reading->roster, name, "is neither a folder nor an archive");
    else {
        source.loose = S_ISREG(info.st_mode) && !archive_is_name(name);
        source.changed = info.st_mtim;
        source.name = strdup(name);
        INVARIANT(source.name);
        reading->sources = grow(reading->sources, reading->count, sizeof *reading->sources);
        reading->sources[reading->count++] = source;
    }
}

// What all the names of a classroom's repositories begin with is not the students'.
static void cut_prefix(Reading *reading) {
    const char **names = calloc((size_t)reading->count + 1, sizeof *names);
    INVARIANT(names);
    for (int i = 0; i < reading->count; i++)
        names[i] = reading->sources[i].told.student;
    const int length = hand_in_prefix(names, reading->count);
    for (int i = 0; i < reading->count; i++) {
        char *student = reading->sources[i].told.student;
        memmove(student, student + length, strlen(student + length) + 1);
    }
    free(names);
}

static bool same_student(const HandIn *a, const HandIn *b) {
    return a->loose == b->loose &&
           hand_in_same_student(a->told.id, a->told.student, b->told.id, b->told.student);
}

static bool is_newer(const HandIn *a, const HandIn *b) {
    const int told = hand_in_compare(&a->told, &b->told);
    if (told != 0)
        return told > 0;
    return a->changed.tv_sec != b->changed.tv_sec ? a->changed.tv_sec > b->changed.tv_sec
                                                  : a->changed.tv_nsec > b->changed.tv_nsec;
}

static RosterEntry *add_entry(Roster *roster, const HandIn *source, const char *name) {
    roster->entries = grow(roster->entries, roster->count, sizeof *roster->entries);
    RosterEntry *entry = &roster->entries[roster->count++];
    *entry = (RosterEntry){.name = strdup(name),
                           .shown = printable_name(name),
                           .student = printable_name(source->told.student),
                           .id = printable_name(source->told.id),
                           .late = source->told.late,
                           .time = source->told.time,
                           .attempts = 1};
    INVARIANT(entry->name);
    printable_file_name(entry->file, name);
    return entry;
}

static void add_loose(RosterEntry *entry, const HandIn *source) {
    entry->loose = grow(entry->loose, entry->loose_count, sizeof *entry->loose);
    entry->loose[entry->loose_count] = strdup(source->name);
    INVARIANT(entry->loose[entry->loose_count]);
    entry->loose_count++;
    entry->late = entry->late || source->told.late;
    entry->time = source->told.time > entry->time ? source->told.time : entry->time;
}

// The loose files of one student are one hand-in. Of two files that he has named alike the newer counts.
static void gather_loose(Reading *reading, int first) {
    char name[2 * HAND_IN_TEXT + 2];
    const HandIn *source = &reading->sources[first];
    for (int i = 0; i < first; i++)
        if (same_student(&reading->sources[i], source))
            return;
    snprintf(name, sizeof name, "%s_%s", source->told.student, source->told.id);
    RosterEntry *entry = add_entry(reading->roster, source, name);
    for (int i = first; i < reading->count; i++) {
        bool newest = same_student(&reading->sources[i], source);
        for (int j = first; newest && j < reading->count; j++)
            newest = j == i || !same_student(&reading->sources[j], source) ||
                     strcmp(reading->sources[j].told.file, reading->sources[i].told.file) != 0 ||
                     is_newer(&reading->sources[i], &reading->sources[j]);
        if (newest)
            add_loose(entry, &reading->sources[i]);
    }
}

static int count_attempts(const Reading *reading, const HandIn *source) {
    int count = 0;
    for (int i = 0; i < reading->count; i++)
        count += same_student(&reading->sources[i], source);
    return count;
}

static void take(Reading *reading, int i, bool all_attempts) {
    const HandIn *source = &reading->sources[i];
    if (source->loose) {
        gather_loose(reading, i);
        return;
    }
    for (int j = 0; !all_attempts && j < reading->count; j++)
        if (j != i && same_student(&reading->sources[j], source) &&
            (is_newer(&reading->sources[j], source) || (!is_newer(source, &reading->sources[j]) && j < i))) {
            ignore(reading->roster, source->name, "is an older attempt of a student who has a newer one");
            return;
        }
    add_entry(reading->roster, source, source->name)->attempts = count_attempts(reading, source);
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

bool roster_read(Roster *roster, const char *folder, const char *output, bool all_attempts) {
    *roster = (Roster){0};
    Reading reading = {.roster = roster};
    if (strlen(folder) > FILES_PATH - 300)
        return check_fail("the path of the class's folder is too long");
    snprintf(roster->folder, sizeof roster->folder, "%s", folder);
    if (!output || stat(output, &reading.output) != 0)
        reading.output = (struct stat){0};
    const bool ok = files_list(folder, add_source, &reading);
    cut_prefix(&reading);
    for (int i = 0; i < reading.count; i++)
        take(&reading, i, all_attempts);
    for (int i = 0; i < reading.count; i++)
        free(reading.sources[i].name);
    free(reading.sources);
    return ok && (roster->count > 0 || check_fail("%s holds no folder and no archive", folder)) &&
           files_differ(roster);
}

static void free_entry(RosterEntry *entry) {
    for (int i = 0; i < entry->loose_count; i++)
        free(entry->loose[i]);
    free(entry->loose);
    free(entry->name);
    free(entry->shown);
    free(entry->student);
    free(entry->id);
}

void roster_destroy(Roster *roster) {
    for (int i = 0; i < roster->count; i++)
        free_entry(&roster->entries[i]);
    for (int i = 0; i < roster->ignored_count; i++)
        free(roster->ignored[i].name);
    free(roster->entries);
    free(roster->ignored);
    *roster = (Roster){0};
}

bool roster_fetch(const Roster *roster, const RosterEntry *entry, char path[FILES_PATH], bool *made) {
    enum { MAX_LOOSE = 1 << 20 };
    char to[FILES_PATH];
    *made = entry->loose != NULL;
    if (!*made) {
        files_join(path, roster->folder, entry->name);
        return true;
    }
    bool ok = files_make_temporary(path);
    for (int i = 0; ok && i < entry->loose_count; i++) {
        HandInName told;
        hand_in_name_read(&told, entry->loose[i]);
        files_join(to, path, told.file);
        ok = files_take(roster->folder, entry->loose[i], to, MAX_LOOSE);
    }
    return ok;
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
