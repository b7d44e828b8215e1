// The limits of a process in the jail.
#pragma once

#include "jail/inside/shim_plan.h"

// Lowers what the grader's own limits (process.h) leave: descriptors, processes, locked memory, queues. They
// can only be set here: the number of processes must count inside the user namespace.
void shim_limit(const ShimPlan *plan);
