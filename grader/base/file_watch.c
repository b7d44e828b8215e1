#include "base/file_watch.h"

#include "base/hash.h"
#include "scene/count.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

typedef struct Fingerprint {
    const char *folder;
    uint64_t hash;
} Fingerprint;

bool file_watch_is_source(const char *name) {
    static const char *const ends[] = {".c", ".h", ".vert", ".frag", ".geom", ".glsl"};
    const char *dot = strrchr(name, '.');
    for (unsigned i = 0; dot && i < COUNT(ends); i++)
        if (strcmp(dot, ends[i]) == 0)
            return true;
    return false;
}

static void add_file(const char *name, void *context) {
    Fingerprint *print = context;
    struct stat info = {0};
    char path[FILES_PATH];
    if (!file_watch_is_source(name) && strcmp(name, "predictions.txt") != 0)
        return;
    files_join(path, print->folder, name);
    if (stat(path, &info) != 0)
        return;
    print->hash = hash_bytes(print->hash, name, strlen(name));
    print->hash = hash_bytes(print->hash, &info.st_size, sizeof info.st_size);
    print->hash = hash_bytes(print->hash, &info.st_ino, sizeof info.st_ino);
    print->hash = hash_bytes(print->hash, &info.st_mtim, sizeof info.st_mtim);
}

static uint64_t fingerprint(const FileWatch *changes) {
    Fingerprint print = {.hash = HASH_START};
    for (int i = 0; i < CHANGES_FOLDERS; i++) {
        print.folder = changes->folders[i];
        if (print.folder[0])
            files_list(print.folder, add_file, &print);
    }
    return print.hash;
}

void file_watch_begin(FileWatch *changes, const char *folder, const char *other) {
    snprintf(changes->folders[0], FILES_PATH, "%s", folder);
    snprintf(changes->folders[1], FILES_PATH, "%s", other);
    changes->taken = changes->seen = fingerprint(changes);
}

bool file_watch_found(FileWatch *changes) {
    uint64_t now = fingerprint(changes);
    bool still = now == changes->seen;
    changes->seen = now;
    if (!still || now == changes->taken)
        return false;
    changes->taken = now;
    return true;
}
