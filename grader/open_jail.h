// Decides where submissions are compiled and run.
#pragma once

#include "options.h"

#include <stdbool.h>

// Makes the jail that the options ask for and puts it into options->grade.jail; what there is to say about it
// goes to standard error. False with a message when none holds. jail_destroy frees it.
bool open_jail(Options *options, Jail *jail);
