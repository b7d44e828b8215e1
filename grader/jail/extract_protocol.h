// What jail_extract and inside/unpack.c say to each other. To descriptor 0: the archive's size (uint64_t) and
// bytes. From descriptor 3: for each file an ExtractEntry and its bytes; then one of another kind, and no
// more.
#pragma once

#include <stdint.h>

enum {
    EXTRACT_MAX_ARCHIVE = 64 << 20, // bytes of the archive
    EXTRACT_MAX_FILE = 16 << 20,    // bytes of one file in it
    EXTRACT_MAX_BYTES = 64 << 20,   // of all
    EXTRACT_MAX_FILES = 4000
};

typedef enum ExtractKind { EXTRACT_FILE = 1, EXTRACT_END, EXTRACT_REFUSED } ExtractKind;

typedef struct ExtractEntry {
    uint32_t kind;
    uint32_t size;   // bytes of the file
    char text[1024]; // its name, or why the archive is refused
} ExtractEntry;
