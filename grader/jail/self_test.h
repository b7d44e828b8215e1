// Before anything untrusted runs, our own attacks do (inside/attack.c).
#pragma once

#include "jail/plan.h"

#include <stdbool.h>

// How a process is started in the jail, like jail_start.
typedef bool StartInJail(const Jail *jail, const JailPlan *plan, Process *process, char *const *arguments,
                         char *const *environment);

// Runs them in one kind of the jail, by another way into it. True when nothing gets through; else false with
// a message.
bool self_test_of(const Jail *jail, JailKind kind, StartInJail *start);

// Runs them in both kinds of the jail, by its route. True when the jail starts, lets through what it must and
// nothing else; else false with a message that names the first attack that got through.
bool self_test(const Jail *jail);
