// Walks through what was handed in, and hashes names, sizes and bytes on the way.
#include "class/hand_in_facts.h"

#include "base/hash.h"
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
    uint64_t hash;
    time_t newest;
    int depth, *entries;
} HashWalk;

static void add_name(HashWalk *walk, const char *name) {
    walk->hash = hash_bytes(walk->hash, name, strlen(name) + 1);
}

// A file's size and bytes; of one that is larger than any that is opened only the size.
static void add_file(HashWalk *walk, const char *path) {
    static _Thread_local char block[BLOCK];
    struct stat info;
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
    if (file < 0)
        return;
    if (fstat(file, &info) == 0 && S_ISREG(info.st_mode)) {
        const uint64_t size = (uint64_t)info.st_size;
        walk->hash = hash_bytes(walk->hash, &size, sizeof size);
        walk->newest = info.st_mtime > walk->newest ? info.st_mtime : walk->newest;
        for (ssize_t n; size <= EXTRACT_MAX_ARCHIVE && (n = read(file, block, sizeof block)) > 0;)
            walk->hash = hash_bytes(walk->hash, block, (size_t)n);
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

uint64_t hand_in_hash_folder(uint64_t hash, const char *folder, bool (*wants)(const char *name),
                             time_t *newest) {
    int entries = 0;
    HashWalk walk = {folder, wants, hash, newest ? *newest : 0, 0, &entries};
    files_list(folder, visit, &walk);
    check_clear();
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

HandInFacts hand_in_facts(const Roster *roster, const RosterEntry *entry) {
    char path[FILES_PATH];
    HandInFacts facts = {.time = entry->time, .told = entry->time != 0};
    HashWalk walk = {.hash = HASH_START};
    files_join(path, roster->folder, entry->name);
    if (entry->loose)
        add_loose(&walk, roster, entry);
    else if (files_is_folder(path))
        walk.hash = hand_in_hash_folder(walk.hash, path, wants, &walk.newest);
    else
        add_file(&walk, path);
    if (!facts.told)
        facts.time = walk.newest;
    facts.hash = walk.hash;
    return facts;
}
