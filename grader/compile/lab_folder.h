// Folders ready to be drawn from: the lab's files and lab.so.
#pragma once

#include "compile/compiler.h"
#include "base/files.h"
#include "compile/rubric.h"

#include <stdbool.h>

// From the annotated source: the solution, the skeleton or something between, with a change from the rubric
// (NULL for none). Kept in build/cache under a name made from its content, and found there the next time.
// False with a message.
bool lab_folder_ours(char folder[FILES_PATH], const Rubric *rubric, Solved solved, const Change *change);

// Does each edit of a mistake or an alternative find its text in the solution, exactly once? False with a
// message.
bool lab_folder_can_change(const Rubric *rubric, const Change *change);

// From a submission: copies only the files that the rubric names to the new folder `folder` and compiles
// them in the jail (NULL: the grader's own user trusts it). `log` gets gcc's words. False with a message that
// names the file that is missing, unusual or wrong.
bool lab_folder_submission(const char *folder, const Rubric *rubric, const char *submission, const Jail *jail,
                           char log[COMPILE_LOG]);

// The same, but lab.so is taken from `earlier` (NULL: none), a folder that was made so before, when no file
// of C has changed since: a change of a shader needs no compiler of C.
bool lab_folder_again(const char *folder, const char *earlier, const Rubric *rubric, const char *submission,
                      const Jail *jail, char log[COMPILE_LOG]);

// The same from texts, in the order of rubric->files, of which some are ours: the folder is for a diagnosis.
// Of lab.c only lab.so stays there. False when it does not compile, without a word of why.
bool lab_folder_mixed(const char *folder, const char *earlier, const Rubric *rubric, char *const *texts,
                      const Jail *jail);

// Our source of the file number i, with these tasks solved; its lines have the numbers of the annotated one.
// The caller frees it; NULL with a message.
char *lab_folder_source(const Rubric *rubric, int i, Solved solved);

enum { DERIVE_MAX_FILE = 1 << 18 };

// Is a file of this name one that goes into lab.so, and no shader?
bool lab_folder_is_c(const char *name);
