#include "jail/jail.h"

#include "scene/check.h"
#include "jail/bwrap_command.h"
#include "jail/stage.h"

#include <errno.h>
#include <ftw.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *const route_names[] = {"none", "bwrap", "landlock"};

const char *jail_route_name(JailRoute route) {
    return route_names[route];
}

bool jail_take_route(void *route, const char *name) {
    JailRoute *taken = route;
    for (*taken = JAIL_BWRAP; *taken <= JAIL_LANDLOCK; (*taken)++)
        if (strcmp(name, route_names[*taken]) == 0)
            return true;
    return check_fail("takes bwrap or landlock, not \"%s\"", name);
}

void jail_destroy(Jail *jail) {
    stage_destroy(jail->stage);
    memset(jail, 0, sizeof *jail);
}

static unsigned lent_to;

static int lend_entry(const char *path, const struct stat *info, int type, struct FTW *position) {
    (void)type, (void)position;
    bool folder = S_ISDIR(info->st_mode);
    return S_ISLNK(info->st_mode) || (lchown(path, (uid_t)-1, lent_to) == 0 &&
                                      chmod(path, folder || info->st_mode & S_IXUSR ? 0750 : 0640) == 0)
               ? 0
               : -1;
}

// The user inside gets the folders by his group; the writable one, which is empty, becomes his. The stage is
// everybody's already, and its programs must stay so.
bool jail_lend(const Jail *jail, const JailPlan *plan) {
    if (!jail->user || strcmp(plan->folder, jail->stage) == 0)
        return true;
    lent_to = jail->user;
    bool ok = nftw(plan->folder, lend_entry, 16, FTW_PHYS) == 0 &&
              (!plan->writable || chown(plan->writable, jail->user, jail->user) == 0);
    return ok ||
           check_fail("%s cannot be handed to the user inside the jail: %s", plan->folder, strerror(errno));
}

bool jail_start(const Jail *jail, const JailPlan *plan, Process *process, char *const *arguments,
                char *const *environment) {
    if (!jail)
        return process_start(process, arguments, environment, plan->folder, &plan->limits);
    BwrapCommand command;
    ProcessLimits limits = plan->limits;
    limits.untrusted = true;
    limits.user = jail->user;
    bwrap_command_make(&command, jail, plan, arguments);
    bool ok = jail_lend(jail, plan) && process_start(process, command.arguments, environment,
                                                     jail->route == JAIL_BWRAP ? "/" : plan->folder, &limits);
    process->wrapped = ok && jail->route == JAIL_BWRAP;
    return ok;
}
