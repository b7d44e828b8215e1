#include "base/file_watch.h"

#include "base/hash.h"
#include "scene/count.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

typedef struct Look {
    const char *folder;
    uint64_t hash;
} Look;

bool file_watch_is_source(const char *name) {
    static const char *const ends[] = {".c", ".h", ".vert", ".frag", ".geom", ".glsl"};
    const char *dot = strrchr(name, '.');
    for (unsigned i = 0; dot && i < COUNT(ends); i++)
        if (strcmp(dot, ends[i]) == 0)
            return true;
    return false;
}

static void look_at(const char *name, void *context) {
    Look *look = context;
    struct stat info = {0};
    char path[FILES_PATH];
    if (!file_watch_is_source(name))
        return;
    files_join(path, look->folder, name);
    if (stat(path, &info) != 0)
        return;
    look->hash = hash_bytes(look->hash, name, strlen(name));
    look->hash = hash_bytes(look->hash, &info.st_size, sizeof info.st_size);
    look->hash = hash_bytes(look->hash, &info.st_ino, sizeof info.st_ino);
    look->hash = hash_bytes(look->hash, &info.st_mtim, sizeof info.st_mtim);
}

static uint64_t fingerprint(const FileWatch *changes) {
    Look look = {.hash = HASH_START};
    for (int i = 0; i < CHANGES_FOLDERS; i++) {
        look.folder = changes->folders[i];
        if (look.folder[0])
            files_list(look.folder, look_at, &look);
    }
    return look.hash;
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
