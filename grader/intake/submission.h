// What a student hands in: a folder shaped like labs/, or the folder of one lab.
#pragma once

#include "base/files.h"

#include <stdbool.h>

typedef struct Submission {
    char folder[FILES_PATH];
    bool single;       // the folder is that of one lab,
    char single_id[3]; // which has this number, or "" when its name does not tell
} Submission;

// Looks at the folder; goes into it as long as it holds nothing but one other folder (archives are often
// wrapped so). False with a message when it is no folder.
bool submission_open(Submission *submission, const char *folder);

// Where the lab "03" lies. False when the submission has none; a link to a folder is none, for it may lead
// out of the submission.
bool submission_find(const Submission *submission, const char *id, char folder[FILES_PATH]);
