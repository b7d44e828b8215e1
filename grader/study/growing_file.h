// A file that grows in memory, scene by scene, and is written when it is whole.
#pragma once

#include "base/files.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct GrowingFile {
    char path[FILES_PATH], *text;
    size_t size;
    FILE *out; // what is printed to it becomes the file
} GrowingFile;

// False with a message when there is no memory.
bool growing_file_begin(GrowingFile *file, const char *folder, const char *name);

// Writes the file and frees what was kept. False with a message.
bool growing_file_end(GrowingFile *file);
