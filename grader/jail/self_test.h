// Before anything untrusted runs, our own attacks do (inside/attack.c).
#pragma once

#include "jail/plan.h"

#include <stdbool.h>

// Runs them in both kinds of the jail, by its route. True when the jail starts, lets through what it must and
// nothing else; else false with a message that names the first attack that got through.
bool self_test(const Jail *jail);
