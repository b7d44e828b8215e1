// Which system calls a process in the jail may make.
#pragma once

#include "jail/inside/shim_plan.h"

// Allows only the system calls that drawing or compiling needs. All others fail with EPERM; a call by another
// architecture's table kills.
void shim_filter(const ShimPlan *plan);
