// Decides where submissions are compiled and run.
#pragma once

#include "jail/plan.h"

#include <stdbool.h>

// Finds the first route that holds on this machine, by attacking it from inside (self_test.h); with `only`
// other than JAIL_NONE no other route is tried. False with a message when none holds: then nothing may be
// graded but what its own author grades outside.
bool jail_create(Jail *jail, JailRoute only);

// What a command line asks for: jail_create by the route `only`, or nothing when `trusted`. *chosen is the
// jail, or NULL when trusted. What there is to say about it goes to standard error after the program's name.
// False with a message when no jail holds. jail_destroy frees it.
bool jail_choose(Jail *jail, JailRoute only, bool trusted, const char *program, const Jail **chosen);
