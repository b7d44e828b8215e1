// jail_shim [-c] [-l] [-r PATH]... [-w PATH]... -- PROGRAM ARGUMENT...
//
// Runs PROGRAM (looked for in PATH) with nothing but what is named: -r readable, -w writable, -c with
// children. -l: fail where Landlock cannot hold.
#include "jail/inside/shim_files.h"
#include "jail/inside/shim_filter.h"
#include "jail/inside/shim_limit.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <unistd.h>

enum { FIRST_FOREIGN = 4 }; // 0 to 3 are the protocol's

static void add_path(const char **paths, int *count, const char *path) {
    if (*count == SHIM_PATHS) {
        errno = E2BIG;
        shim_fail("paths");
    }
    paths[(*count)++] = path;
}

static void parse(ShimPlan *plan, int count, char **arguments) {
    for (int option; (option = getopt(count, arguments, "+clr:w:")) != -1;)
        switch (option) {
        case 'c':
            plan->children = true;
            break;
        case 'l':
            plan->needs_landlock = true;
            break;
        case 'r':
            add_path(plan->readable, &plan->readable_count, optarg);
            break;
        case 'w':
            add_path(plan->writable, &plan->writable_count, optarg);
            break;
        default:
            errno = EINVAL;
            shim_fail("options");
        }
}

int main(int count, char **arguments) {
    static ShimPlan plan;
    parse(&plan, count, arguments);
    if (optind == count)
        shim_fail("no program");
    close_range(FIRST_FOREIGN, ~0u, 0);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        shim_fail("no_new_privs");
    shim_limit(&plan);
    shim_hide_files(&plan);
    shim_filter(&plan);
    execvp(arguments[optind], arguments + optind);
    shim_fail(arguments[optind]);
}
