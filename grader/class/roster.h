// Who hands in: the entries of the class's folder.
#pragma once

#include "base/printable.h"
#include "base/files.h"

#include <stdbool.h>

typedef struct RosterEntry {
    char *name;                  // as it stands in the folder, any bytes
    char *shown;                 // the same as text (printable_name)
    char file[ESCAPE_FILE_NAME]; // names its files in OUT
    bool archive;                // else a folder
} RosterEntry;

typedef struct Roster {
    char folder[FILES_PATH];
    RosterEntry *entries; // in the order of their bytes
    int count;
    char **ignored; // as text: what is neither a folder nor an archive, or hidden
    int ignored_count;
} Roster;

// Reads the folder. False with a message.
bool roster_read(Roster *roster, const char *folder);
void roster_destroy(Roster *roster); // accepts a zeroed roll

// The number of the entry of this name, text or file name; -1 with a message when there is none.
int roster_find(const Roster *roster, const char *name);
