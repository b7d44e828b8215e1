// What the parts of the shim are told: the last thing of ours that runs before untrusted code. It stands
// alone: no other module of the grader is linked into it.
#pragma once

#include <stdbool.h>

enum { SHIM_PATHS = 40 };

typedef struct ShimPlan {
    bool children;       // may start processes and programs, and open files for writing
    bool needs_landlock; // without namespaces nothing else keeps files apart
    const char *readable[SHIM_PATHS], *writable[SHIM_PATHS];
    int readable_count, writable_count;
} ShimPlan;

// Prints "jail: ..." with the system's words and ends with status 125.
_Noreturn void shim_fail(const char *what);
