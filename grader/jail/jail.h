// A jail for untrusted code: compilers, workers and unpackers that read or run what a student handed in.
//
// Two routes lead into it. With bubblewrap the process gets namespaces of its own, in which nothing is
// mounted but what it needs; without user namespaces Landlock alone keeps it from all other files. On both
// the shim (inside/shim.c) sets the limits, Landlock and the list of allowed system calls before the
// untrusted code begins.
//
// Interface: jail_choose (jail_choose.h) finds a route that holds and fills a Jail; jail_start runs a program
// in it by a JailPlan (plan.h); jail_part tells where our parts lie inside; jail_destroy removes them.
#pragma once

#include "jail/plan.h"

// "bwrap", "landlock" or "none".
const char *jail_route_name(JailRoute route);

// An option's value (base/command_line.h): `route` is a JailRoute. False with a message when `name` is
// neither "bwrap" nor "landlock".
bool jail_take_route(void *route, const char *name);

void jail_destroy(Jail *jail); // accepts a zeroed jail

// Hands the plan's folders to the user inside, where the grader is root. False with a message. For who starts
// something in the jail in another way than jail_start.
bool jail_lend(const Jail *jail, const JailPlan *plan);

// Starts arguments[0] in the jail like process_start. As root, hands the plan's folders to the user inside.
// With a NULL jail it starts the program outside, in plan->folder, with the plan's limits: for what is our
// own.
bool jail_start(const Jail *jail, const JailPlan *plan, Process *process, char *const *arguments,
                char *const *environment);
