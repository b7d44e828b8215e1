// Who hands in: the entries of the class's folder.
#pragma once

#include "base/printable.h"
#include "base/files.h"

#include <stdbool.h>

typedef struct Entry {
    char *name;                  // as it stands in the folder, any bytes
    char *shown;                 // the same as text (escape_name)
    char file[ESCAPE_FILE_NAME]; // names its files in OUT
    bool archive;                // else a folder
} Entry;

typedef struct Roll {
    char folder[FILES_PATH];
    Entry *entries; // in the order of their bytes
    int count;
    char **ignored; // as text: what is neither a folder nor an archive, or hidden
    int ignored_count;
} Roll;

// Reads the folder. False with a message.
bool roll_read(Roll *roll, const char *folder);
void roll_destroy(Roll *roll); // accepts a zeroed roll

// The number of the entry of this name, text or file name; -1 with a message when there is none.
int roll_find(const Roll *roll, const char *name);
