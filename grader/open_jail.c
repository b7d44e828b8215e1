#include "open_jail.h"

#include <stdio.h>

bool open_jail(Options *options, Jail *jail) {
    if (options->trusted) {
        fputs("grade: --trusted: the submission is compiled and run outside the jail\n", stderr);
        return true;
    }
    if (!jail_create(jail, options->route)) {
        fputs("grade: nothing was graded: where no jail holds, strangers' code could read the solutions or "
              "harm this "
              "machine.\n  As a teacher: install bubblewrap, or grade in a virtual machine. Grading your own "
              "work: add "
              "--trusted (make grade ARGS=--trusted)\n",
              stderr);
        return false;
    }
    if (jail->route != JAIL_BWRAP)
        fprintf(stderr, "grade: the fallback jail is in use: %s%s%s\n", jail_route_name(jail->route),
                jail->why[0] ? ", for " : "", jail->why);
    options->grade.jail = jail;
    return true;
}
