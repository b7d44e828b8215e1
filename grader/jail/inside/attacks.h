// What untrusted code may try, tried by us.
#pragma once

#include <stdbool.h>
#include <sys/types.h>

typedef struct AttackTarget {
    bool tools, sanitized;
    const char *visible; // a file that may be read
    const char *out;     // a folder that may be written to where `tools`
    const char *secret;  // a file that is readable and writable for all but for the jail
    const char *solutions;
    pid_t grader;
} AttackTarget;

typedef struct Attack {
    const char *name;
    bool (*run)(const AttackTarget *target); // true: it got through
    bool only_draw;                          // allowed to the compiler
    bool not_sanitized;                      // allowed where a sanitizer needs it
} Attack;

// Each list ends with a zeroed attack.
extern const Attack attacks_on_files[], attacks_on_processes[], attacks_on_kernel[];

bool attack_read(const char *path);                      // can a byte of the file be read?
bool attack_write(const char *folder, const char *name); // can folder/name be made and written?

// On x86-64 a system call by the table of i386. Ends the process where it is forbidden; else prints a line.
void attack_by_other_architecture(void);
