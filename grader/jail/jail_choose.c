#include "jail/jail_choose.h"

#include "scene/check.h"
#include "jail/jail.h"
#include "jail/self_test.h"
#include "jail/stage.h"

#include <stdio.h>
#include <unistd.h>

// Of no account: above Debian's system users (adduser: 100 to 999) and ordinary ones (1000 to 59999).
enum { JAIL_USER = 60611 };

bool jail_create(Jail *jail, JailRoute only) {
    char why[900] = "";
    *jail = (Jail){.user = geteuid() == 0 ? JAIL_USER : 0};
    if (!stage_create(jail->stage))
        return false;
    for (jail->route = JAIL_BWRAP; jail->route <= JAIL_LANDLOCK; jail->route++) {
        if (only != JAIL_NONE && only != jail->route)
            continue;
        check_clear();
        if (self_test(jail)) {
            if (jail->route != JAIL_BWRAP)
                snprintf(jail->notice, sizeof jail->notice, "the fallback jail is in use: %s%s%s",
                         jail_route_name(jail->route), why[0] ? ", for " : "", why);
            return true;
        }
        check_append(why, sizeof why, "%s%s: %.400s", why[0] ? "; " : "", jail_route_name(jail->route),
                     check_message());
    }
    jail_destroy(jail);
    check_clear();
    return check_fail(
        "no jail holds on this machine (%s). Untrusted code could read the solutions or harm it: "
        "install bubblewrap, or grade in a virtual machine. If the submission is your own work, add "
        "--trusted (make grade ARGS=--trusted)",
        why);
}

bool jail_choose(Jail *jail, JailRoute only, bool trusted, const char *program, const Jail **chosen) {
    *chosen = NULL;
    if (trusted) {
        fprintf(stderr, "%s: --trusted: the submission is compiled and run outside the jail\n", program);
        return true;
    }
    if (!jail_create(jail, only))
        return false;
    if (jail->notice[0])
        fprintf(stderr, "%s: %s\n", program, jail->notice);
    *chosen = jail;
    return true;
}
