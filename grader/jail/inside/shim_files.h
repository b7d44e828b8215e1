// Which files a process in the jail can reach.
#pragma once

#include "jail/inside/shim_plan.h"

// Keeps all files away but those of the plan (Landlock; Linux 5.13 and, where the plan needs it, 6.2).
void shim_hide_files(const ShimPlan *plan);
