// What a child process may do.
#pragma once

#include <stdbool.h>

typedef struct ProcessLimits {
    double wall_seconds;                        // for the whole life of the process
    unsigned cpu_seconds, memory_mib, file_mib; // 0: no limit
    unsigned resident_mib; // memory that it and its group may hold, watched by us every PROCESS_MEMORY_SLICE
                           // seconds: for what RLIMIT_AS cannot limit; 0: no limit
    bool untrusted; // no terminal, and dies with us; none of its descendants may found a session or a group
    unsigned user;  // uid and gid of untrusted code; 0: ours
} ProcessLimits;
