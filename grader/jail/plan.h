// What a jail is, and what a process in it gets.
#pragma once

#include "base/files.h"
#include "base/process.h"

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
    bool sees_itself;     // it may read what /proc says of itself, of which AddressSanitizer asks its stack
    const char *writable; // a folder that may be written to, absolute; NULL for none
} JailPlan;

// The path inside of one of our parts: "worker", "worker_address", "include", "shaders", "common", or a
// program of inside/. With a NULL jail its path outside.
void jail_part(const Jail *jail, const char *part, char path[FILES_PATH]);
