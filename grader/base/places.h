// Where the parts of Shadow Lab lie, found from the place of the running program (ROOT/build/grade).
#pragma once

#include "base/files.h"

#include <stdbool.h>

// ROOT/relative, for instance "solutions".
void places_path(char path[FILES_PATH], const char *relative);

// BUILD/name, next to the running program, for instance "worker".
void places_build_path(char path[FILES_PATH], const char *name);

// The folder ROOT/solutions/NN-name of the lab whose number `id` is, or ROOT/grader/recorded/NN-name where
// there are no solutions (see exam/exam_file.h); false when there is none.
bool places_find_lab(char path[FILES_PATH], const char *id);

// The same inside another folder that is shaped like labs/.
bool places_find_lab_in(char path[FILES_PATH], const char *parent, const char *id);

// The same, or where there is none, `parent` itself: people name labs/ as well as the folder of one lab.
void places_lab_of(char path[FILES_PATH], const char *parent, const char *id);

// Calls visit with the id ("02") of each lab of ours, in order. False with a message when two folders
// have one number, or when there is none.
bool places_list_labs(void (*visit)(const char *id, void *context), void *context);

// Does an entry's name read "NN-..."?
bool places_is_lab_name(const char *name);
