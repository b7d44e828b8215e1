#include "open_jail.h"

#include <stdio.h>

bool open_jail(Options *options, Jail *jail) {
    if (options->trusted) {
        fputs("grade: --trusted: the submission is compiled and run outside the jail\n", stderr);
        return true;
    }
    if (!jail_create(jail, options->route))
        return false;
    if (jail->notice[0])
        fprintf(stderr, "grade: %s\n", jail->notice);
    options->grade.jail = jail;
    return true;
}
