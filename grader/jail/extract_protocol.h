// What jail_extract and inside/unpack.c say to each other. To descriptor 0: the archive's size (uint64_t) and
// bytes. From descriptor 3: an ExtractEntry that it is ready, before it looks at the archive; for each file
// one and its bytes; then one of another kind, and no more. And what both pass over.
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

enum {
    EXTRACT_MAX_ARCHIVE = 64 << 20, // bytes of the archive
    EXTRACT_MAX_FILE = 16 << 20,    // bytes of one file in it
    EXTRACT_MAX_BYTES = 64 << 20,   // of all
    EXTRACT_MAX_FILES = 4000,
    EXTRACT_MAX_FOLDERS = 2000,
    EXTRACT_MAX_DEPTH = 32 // folders above a file
};

typedef enum ExtractKind { EXTRACT_READY = 1, EXTRACT_FILE, EXTRACT_END, EXTRACT_REFUSED } ExtractKind;

typedef struct ExtractEntry {
    uint32_t kind;
    uint32_t size;   // bytes of the file
    char text[1024]; // its name, or why the archive is refused
} ExtractEntry;

// Does no lab lie in a folder of this name (its first `length` bytes)? Version control, what programs make,
// what an operating system adds.
static inline bool extract_passes_folder(const char *name, size_t length) {
    static const char *const names[] = {"__MACOSX", "node_modules", "build", "CMakeFiles",
                                        "Debug",    "Release",      "x64"};
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strlen(names[i]) == length && strncmp(name, names[i], length) == 0)
            return true;
    return length == 0 || name[0] == '.' || strncmp(name, "cmake-build-", strlen("cmake-build-")) == 0;
}

// Can a file of this name be one of a lab's, or an archive of them? By its ending: what else lies in an
// archive is neither read nor counted.
static inline bool extract_wants_file(const char *name) {
    static const char *const ends[] = {".c",    ".h",    ".frag", ".vert", ".geom", ".glsl", ".tesc", ".tese",
                                       ".json", ".txt",  ".md",   ".zip",  ".tar",  ".gz",   ".tgz",  ".bz2",
                                       ".tbz",  ".tbz2", ".xz",   ".txz",  ".zst",  ".tzst", ".7z",   ".rar"};
    const char *dot = strrchr(name, '.');
    for (unsigned i = 0; dot && i < sizeof ends / sizeof ends[0]; i++)
        if (strcasecmp(dot, ends[i]) == 0)
            return true;
    return false;
}
