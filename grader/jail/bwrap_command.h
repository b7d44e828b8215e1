// The command line that leads into the jail.
#pragma once

#include "jail/plan.h"

enum { COMMAND_MAX = 160 };

typedef struct BwrapCommand {
    char *arguments[COMMAND_MAX]; // ends with NULL; borrows the strings that it was made from
    int count;
    char shim[FILES_PATH], links[4][64];
} BwrapCommand;

// Writes `arguments` and behind them the paths of the system and of ours that a process which draws may see:
// for a nursery.
void bwrap_command_nursery(BwrapCommand *command, const Jail *jail, char *const *arguments);

// Writes the command line that runs `arguments` in the jail as `plan` says.
void bwrap_command_make(BwrapCommand *command, const Jail *jail, const JailPlan *plan,
                        char *const *arguments);
