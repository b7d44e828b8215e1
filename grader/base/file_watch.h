// Sees that source files have changed, by asking for their times: also where file events do not arrive (WSL,
// network folders). Watches what an editor may write: files that are rewritten, renamed over, added or
// removed.
#pragma once

#include "base/files.h"

#include <stdbool.h>
#include <stdint.h>

enum { CHANGES_FOLDERS = 2 };

typedef struct FileWatch {
    char folders[CHANGES_FOLDERS][FILES_PATH]; // "": none
    uint64_t taken, seen;                      // fingerprints: of what was built, and of the last look
} FileWatch;

// Watches C and GLSL files of two folders from now on, and what a student predicts (predictions.txt).
void file_watch_begin(FileWatch *changes, const char *folder, const char *other);

// True once for each change, when two looks in a row have found the same files: a file is not read while it
// is being written.
bool file_watch_found(FileWatch *changes);

// Is it the name of a C or GLSL file?
bool file_watch_is_source(const char *name);
