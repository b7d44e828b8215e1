// What of a hand-in decides over its grade, as a hash, and when it was handed in.
#pragma once

#include "class/roster.h"

#include <stdbool.h>
#include <stdint.h>
#include <time.h>

typedef struct HandInFacts {
    uint64_t hash; // of the names and bytes of all files that the intake may read
    time_t time;   // by the name, else the newest change of these files; 0: unknown
    bool told;     // by the name
} HandInFacts;

// Looks at the entry's files. What cannot be read counts by its name alone: that it cannot be graded will be
// said by who tries.
HandInFacts hand_in_facts(const Roster *roster, const RosterEntry *entry);

// The same as a number that nobody can foresee, or make come twice, without the secret. False when the entry
// holds more files than are looked at, so that the number does not stand for all.
bool hand_in_mark(uint64_t *mark, const Roster *roster, const RosterEntry *entry, uint64_t secret);

// Goes on from `hash` over the size and the bytes of a file; a file that is not there adds nothing.
uint64_t hand_in_hash_file(uint64_t hash, const char *path);

// Goes on from `hash` over the names and bytes of the files in a folder and below it for which `wants` is
// true, in the order of their names; folders that extract_passes_folder names are passed over. *newest gets
// the newest change, if it is newer; NULL: nobody asks.
uint64_t hand_in_hash_folder(uint64_t hash, const char *folder, bool (*wants)(const char *name),
                             time_t *newest);
