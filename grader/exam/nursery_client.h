// Our end of a nursery (worker/nursery.h): workers that are forked in a moment, each into a jail of its own.
#pragma once

#include "base/process.h"
#include "jail/plan.h"
#include "scene/context_kind.h"

// Starts a worker for the plan's folder in `jail` like jail_start. The process's nursery is started when it
// is asked for the second time: who needs one worker needs no nursery. False, without a message, where there
// is none: one that cannot be started, in whose children our own attacks get through (self_test.h), by
// another route than bwrap's. Then a worker is started in the usual way.
bool nursery_start(const Jail *jail, ContextKind context, const JailPlan *plan, Process *process,
                   char *const *environment);

// Ends it; false: there was none. It also ends with us.
bool nursery_stop(void);
