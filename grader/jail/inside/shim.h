// The parts of the shim, the last thing of ours that runs before untrusted code. It stands alone: no other
// module of the grader is linked into it.
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

// Lowers what the grader's own limits (process.h) leave: descriptors, processes, locked memory, queues. They
// can only be set here: the number of processes must count inside the user namespace.
void shim_limit(const ShimPlan *plan);

// Keeps all files away but those of the plan (Landlock; Linux 5.13 and, where the plan needs it, 6.2).
void shim_hide_files(const ShimPlan *plan);

// Allows only the system calls that drawing or compiling needs. All others fail with EPERM; a call by another
// architecture's table kills.
void shim_filter(const ShimPlan *plan);
