// The mutation test of one lab: all small changes of its solution, each tried over some seeds, and what the
// rubric did not notice.
#pragma once

#include <stdbool.h>

typedef struct MutantSettings {
    int seeds;        // 1 to this; a change that a check noticed is not tried again
    int processes;    // at the same time
    const char *only; // those whose line in the list holds this text; NULL: all
} MutantSettings;

// Prints the row "| lab | made | compiled | killed | equal | survived | killed or equal, % |", and before it
// each survivor that equal.json does not name and each of its entries that is refused: one that names no
// change, or one that a check notices. *clean: nothing of that. False with a message: something could not be
// graded.
bool lab_mutants_run(const char *id, const MutantSettings *settings, bool *clean);

// Prints a line for each change, and grades nothing. False with a message.
bool lab_mutants_list(const char *id, const char *only);
