// Decides where submissions are compiled and run.
#pragma once

#include "options.h"

#include <stdbool.h>

// Makes the jail that the options ask for and puts it into options->grade.jail; says so on standard error
// unless it is the first choice. False with a message, and the remedy on standard error, when none holds.
// jail_destroy frees it.
bool open_jail(Options *options, Jail *jail);
