#include "jail/inside/shim_limit.h"

#include <sys/resource.h>

void shim_limit(const ShimPlan *plan) {
    const struct {
        __rlimit_resource_t resource;
        rlim_t value;
    } limits[] = {{RLIMIT_NPROC, plan->children ? 64 : 4}, // bwrap's own two count
                  {RLIMIT_NOFILE, 64},
                  {RLIMIT_CORE, 0},
                  {RLIMIT_MEMLOCK, 0},
                  {RLIMIT_MSGQUEUE, 0},
                  {RLIMIT_SIGPENDING, 64}};
    for (unsigned i = 0; i < sizeof limits / sizeof limits[0]; i++) {
        // Without a user namespace the other processes of the same user would count.
        if (limits[i].resource == RLIMIT_NPROC && plan->needs_landlock)
            continue;
        if (setrlimit(limits[i].resource, &(struct rlimit){limits[i].value, limits[i].value}) != 0)
            shim_fail("a limit cannot be set");
    }
}
