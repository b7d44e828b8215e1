// Who hands in: the entries of the class's folder, one a student.
#pragma once

#include "base/printable.h"
#include "base/files.h"

#include <stdbool.h>
#include <time.h>

typedef struct RosterEntry {
    char *name;                  // as it stands in the folder, any bytes; of loose files "STUDENT_ID"
    char *shown;                 // the same as text (printable_name)
    char file[ESCAPE_FILE_NAME]; // names its files in OUT
    char *student, *id;          // what the name tells of who it is, as text; "" for no id
    bool late;
    time_t time;  // when it was handed in, where the name tells; else 0
    char **loose; // names of the files, where they lie loose in the class's folder; NULL: a folder or archive
    int loose_count;
    int attempts; // of this student in the folder, where each is a hand-in; this is the newest, or all are
                  // graded
} RosterEntry;

// What is not graded, and why: both as text.
typedef struct RosterIgnored {
    char *name;
    const char *why;
} RosterIgnored;

typedef struct Roster {
    char folder[FILES_PATH];
    RosterEntry *entries; // in the order of their bytes
    int count;
    RosterIgnored *ignored;
    int ignored_count;
} Roster;

// Reads the folder. `output`, when it lies in there (NULL: none), is no hand-in. Of several attempts of one
// student the newest is an entry, and the others are ignored; with `all_attempts` each is an entry. The
// newest is told by the names (hand_in_name.h), else by the time of the last change. False with a message.
bool roster_read(Roster *roster, const char *folder, const char *output, bool all_attempts);
void roster_destroy(Roster *roster); // accepts a zeroed roll

// Where an entry lies: its path, or for loose files a new temporary folder with copies of them, under the
// names that the student gave them; *made says that it is to be removed. False with a message.
bool roster_fetch(const Roster *roster, const RosterEntry *entry, char path[FILES_PATH], bool *made);

// The number of the entry of this name, text or file name; -1 with a message when there is none.
int roster_find(const Roster *roster, const char *name);
