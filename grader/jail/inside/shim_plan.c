#include "jail/inside/shim_plan.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

_Noreturn void shim_fail(const char *what) {
    dprintf(STDERR_FILENO, "jail: %s: %s\n", what, strerror(errno));
    _exit(125);
}
