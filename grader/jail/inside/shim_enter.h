// The way into a jail for a process that is forked, and not started: what bwrap and the shim do for others.
#pragma once

#include "jail/inside/shim_plan.h"

#include <sys/types.h>

typedef struct ShimOwner {
    uid_t user;
    gid_t group;
} ShimOwner;

// Forks as fork does, with a child in new namespaces: of users, mounts, processes, IPC, network, names and
// cgroups. It is a child of our parent. For a process of one thread. -1: it cannot.
pid_t shim_enter_fork(void);

// In that child, which from here on is two: number 1 of the new processes watches over number 2 and ends as
// that does, and number 2 goes on. It stays `owner`, without any capability. All that is left of the files is
// what the plan says is readable, read only, and it is in `folder`, one of them. Descriptors from 4 on are
// closed. Then limits, Landlock and the filter of system calls.
void shim_enter(const ShimPlan *plan, const char *folder, const ShimOwner *owner);
