// Walks through what was handed in, and hashes names, sizes and bytes on the way.
#include "class/hand_in_facts.h"

#include "base/hash.h"
#include "base/siphash.h"
#include "class/hand_in_time.h"
#include "jail/extract_protocol.h"
#include "scene/check.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_DEPTH = 32, MOST_ENTRIES = 20000, BLOCK = 1 << 16 };

typedef struct HashWalk {
    const char *folder;
    bool (*wants)(const char *name);
    const uint64_t *secret; // NULL: anybody may make two of one hash
    uint64_t hash;
    time_t newest;
    int depth, *entries;
} HashWalk;

static void add(HashWalk *walk, const void *bytes, size_t size) {
    walk->hash = walk->secret ? siphash((const uint64_t[2]){*walk->secret, walk->hash}, bytes, size)
                              : hash_bytes(walk->hash, bytes, size);
}

static void add_name(HashWalk *walk, const char *name) {
    add(walk, name, strlen(name) + 1);
}

// Whole blocks, however few bytes come at a time: where one ends must not depend on the file system.
static void add_bytes(HashWalk *walk, int file) {
    static _Thread_local char block[BLOCK];
    size_t filled = 0;
    for (ssize_t n; (n = read(file, block + filled, sizeof block - filled)) > 0;) {
        filled += (size_t)n;
        if (filled < sizeof block)
            continue;
        add(walk, block, filled);
        filled = 0;
    }
    add(walk, block, filled);
}

// A file's size and bytes; of one that is larger than any that is opened only the size.
static void add_file(HashWalk *walk, const char *path) {
    struct stat info;
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
    if (file < 0)
        return;
    if (fstat(file, &info) == 0 && S_ISREG(info.st_mode)) {
        const uint64_t size = (uint64_t)info.st_size;
        add(walk, &size, sizeof size);
        walk->newest = info.st_mtime > walk->newest ? info.st_mtime : walk->newest;
        if (size <= EXTRACT_MAX_ARCHIVE)
            add_bytes(walk, file);
    }
    close(file);
}

uint64_t hand_in_hash_file(uint64_t hash, const char *path) {
    HashWalk walk = {.hash = hash};
    add_file(&walk, path);
    return walk.hash;
}

static void visit(const char *name, void *context) {
    HashWalk *walk = context;
    char path[FILES_PATH];
    if (extract_passes_folder(name, strlen(name)) || ++*walk->entries > MOST_ENTRIES ||
        strlen(walk->folder) + strlen(name) + 2 > FILES_PATH)
        return;
    files_join(path, walk->folder, name);
    if (files_is_folder(path)) {
        HashWalk inner = *walk;
        inner.folder = path;
        add_name(&inner, name);
        if (inner.depth++ < MOST_DEPTH)
            files_list(path, visit, &inner);
        add_name(&inner, "/");
        walk->hash = inner.hash;
        walk->newest = inner.newest;
    } else if (walk->wants(name)) {
        add_name(walk, name);
        add_file(walk, path);
    }
}

static void walk_folder(HashWalk *walk, const char *folder) {
    walk->folder = folder;
    files_list(folder, visit, walk);
    check_clear();
}

uint64_t hand_in_hash_folder(uint64_t hash, const char *folder, bool (*wants)(const char *name),
                             time_t *newest) {
    int entries = 0;
    HashWalk walk = {.wants = wants, .hash = hash, .newest = newest ? *newest : 0, .entries = &entries};
    walk_folder(&walk, folder);
    if (newest)
        *newest = walk.newest;
    return walk.hash;
}

static bool wants(const char *name) {
    return extract_wants_file(name);
}

static void add_loose(HashWalk *walk, const Roster *roster, const RosterEntry *entry) {
    char path[FILES_PATH];
    for (int i = 0; i < entry->loose_count; i++) {
        add_name(walk, entry->loose[i]);
        files_join(path, roster->folder, entry->loose[i]);
        add_file(walk, path);
    }
}

static void walk_entry(HashWalk *walk, const Roster *roster, const RosterEntry *entry) {
    char path[FILES_PATH];
    files_join(path, roster->folder, entry->name);
    if (entry->loose)
        add_loose(walk, roster, entry);
    else if (files_is_folder(path))
        walk_folder(walk, path);
    else
        add_file(walk, path);
}

HandInFacts hand_in_facts(const Roster *roster, const RosterEntry *entry) {
    int entries = 0;
    HashWalk walk = {.wants = wants, .hash = HASH_START, .entries = &entries};
    walk_entry(&walk, roster, entry);
    return (HandInFacts){
        .time = entry->time ? entry->time : walk.newest, .told = entry->time != 0, .hash = walk.hash};
}

bool hand_in_mark(uint64_t *mark, const Roster *roster, const RosterEntry *entry, uint64_t secret) {
    static const char kind[] = "hand-in";
    int entries = 0;
    HashWalk walk = {.wants = wants,
                     .secret = &secret,
                     .hash = siphash((const uint64_t[2]){secret, 0}, kind, sizeof kind),
                     .entries = &entries};
    walk_entry(&walk, roster, entry);
    *mark = walk.hash;
    return entries <= MOST_ENTRIES;
}
