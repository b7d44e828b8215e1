// A jail for strangers' code: compilers, workers and unpackers that read or run what a student handed in.
//
// Two routes lead into it. With bubblewrap the process gets namespaces of its own, in which nothing is
// mounted but what it needs; without user namespaces Landlock alone keeps it from all other files. On both
// the shim (inside/shim.c) sets the limits, Landlock and the list of allowed system calls before the
// stranger's code begins.
#pragma once

#include "files.h"
#include "process.h"

#include <stdbool.h>

typedef enum JailRoute { JAIL_NONE, JAIL_BWRAP, JAIL_LANDLOCK } JailRoute;

typedef struct Jail {
    JailRoute route;
    unsigned user;          // uid and gid inside when the grader is root; 0: as the grader
    char stage[FILES_PATH]; // a private folder with copies of our parts that those inside may read
    char notice[1024];      // to be shown to the user; "" where the jail is the best one
} Jail;

typedef enum JailKind {
    JAIL_DRAW, // one process without children or threads; libraries only
    JAIL_TOOLS // the compiler: may start the system's programs, read its headers
} JailKind;

typedef struct JailPlan {
    JailKind kind;
    ProcessLimits limits;
    const char *folder;   // the working folder, readable; absolute
    const char *readable; // one more readable file or folder, absolute; NULL for none
    const char *writable; // a folder that may be written to, absolute; NULL for none
} JailPlan;

// "bwrap", "landlock" or "none".
const char *jail_route_name(JailRoute route);

// False with a message when `name` is neither "bwrap" nor "landlock".
bool jail_parse_route(JailRoute *route, const char *name);

// Finds the first route that holds on this machine, by attacking it from inside (self_test.h); with `only`
// other than JAIL_NONE no other route is tried. False with a message when none holds: then nothing may be
// graded but what its own author grades outside.
bool jail_create(Jail *jail, JailRoute only);

void jail_destroy(Jail *jail); // accepts a zeroed jail

// The path inside of one of our parts: "worker", "include", "shaders", "common", or a program of inside/.
// With a NULL jail its path outside.
void jail_part(const Jail *jail, const char *part, char path[FILES_PATH]);

// Starts arguments[0] in the jail like process_start. As root, hands the plan's folders to the user inside.
// With a NULL jail it starts the program outside, in plan->folder, with the plan's limits: for what is our
// own.
bool jail_start(const Jail *jail, const JailPlan *plan, Process *process, char *const *arguments,
                char *const *environment);
