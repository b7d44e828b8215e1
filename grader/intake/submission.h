// What a student hands in, however it is packed: a folder or an archive in which the labs' folders lie at any
// depth, with archives among them.
#pragma once

#include "base/files.h"
#include "jail/extract.h"

#include <stdbool.h>

enum { SUBMISSION_MAX_LABS = 256, SUBMISSION_MAX_ARCHIVES = 16, SUBMISSION_MAX_DEPTH = 12 };

// A folder that may be a lab's.
typedef struct FoundLab {
    char id[3];   // "" when nothing tells of which lab
    char *folder; // the whole path
    int rank;     // of several of one lab the lowest is graded
} FoundLab;

typedef struct Submission {
    char folder[FILES_PATH];   // of the caller's, or what his archive held
    char unpacked[FILES_PATH]; // a temporary folder for archives; "" for none
    FoundLab labs[SUBMISSION_MAX_LABS];
    int lab_count;
    bool single;                             // what was handed in is the folder of one lab itself
    char *archives[SUBMISSION_MAX_ARCHIVES]; // found and not yet opened
    int archive_count;
    int entries;    // looked at so far
    char note[400]; // what was left out, for who handed it in; "" for nothing
    char why[400];  // the first archive inside that could not be opened, and why
} Submission;

// Looks through a folder or an archive (of a name that archive_is_name knows). An archive is unpacked in the
// jail (NULL: outside, for one's own). BAD with a message for people: what was handed in cannot be opened.
// FAULT with a message: the machine or we are to blame. submission_close is due in each case.
Extracted submission_open(Submission *submission, const Jail *jail, const char *path);

// Frees it and removes what was unpacked. Accepts a zeroed submission.
void submission_close(Submission *submission);

// Where the lab "03" lies: the folder that has its name in labs/, else one whose lab.c has its title, else
// one of a name that says so or below such a name; the one nearest to the top of several. `note` tells of the
// others, "" for none. NULL when there is none. A link to a folder is none, for it may lead out.
const char *submission_find(const Submission *submission, const char *id, char *note, size_t size);

// The folder as who handed it in knows it: within what was handed in, or within an archive.
const char *submission_shown(const Submission *submission, const char *folder);

// The only folder with a lab.c of which nothing within what was handed in tells of which lab it is: it is of
// the one lab that is asked for. NULL when there is none or more.
const char *submission_nameless(const Submission *submission);

// Where one of the `asked` labs lies that are asked for: found by its name or title, or where it is the only
// one, without.
const char *submission_find_of(const Submission *submission, const char *id, int asked, char *note,
                               size_t size);
