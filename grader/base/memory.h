// What a group of processes holds in memory, as /proc tells it from outside.
#pragma once

#include <stdbool.h>
#include <sys/types.h>

// Do the processes of the group hold at most `mib` MiB, all together? False, too, when that cannot be seen.
bool memory_within(pid_t group, unsigned mib);
