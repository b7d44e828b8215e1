#include "jail/jail.h"

#include "check.h"
#include "jail/command.h"
#include "jail/self_test.h"
#include "jail/stage.h"

#include <errno.h>
#include <ftw.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Of no account: above Debian's system users (adduser: 100 to 999) and ordinary ones (1000 to 59999).
enum { JAIL_USER = 60611 };

static const char *const route_names[] = {"none", "bwrap", "landlock"};

const char *jail_route_name(JailRoute route) {
    return route_names[route];
}

bool jail_parse_route(JailRoute *route, const char *name) {
    for (*route = JAIL_BWRAP; *route <= JAIL_LANDLOCK; (*route)++)
        if (strcmp(name, route_names[*route]) == 0)
            return true;
    return check_fail("--jail takes bwrap or landlock, not \"%s\"", name);
}

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
        "no jail holds on this machine (%s). Strangers' code could read the solutions or harm it: "
        "install bubblewrap, or grade in a virtual machine. If the submission is your own work, add "
        "--trusted (make grade ARGS=--trusted)",
        why);
}

void jail_destroy(Jail *jail) {
    stage_destroy(jail->stage);
    memset(jail, 0, sizeof *jail);
}

void jail_part(const Jail *jail, const char *part, char path[FILES_PATH]) {
    if (jail)
        files_join(path, jail->stage, part);
    else
        stage_source(part, path);
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
static bool lend(const Jail *jail, const JailPlan *plan) {
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
    Command command;
    ProcessLimits limits = plan->limits;
    limits.stranger = true;
    limits.user = jail->user;
    command_make(&command, jail, plan, arguments);
    bool ok = lend(jail, plan) && process_start(process, command.arguments, environment,
                                                jail->route == JAIL_BWRAP ? "/" : plan->folder, &limits);
    process->wrapped = ok && jail->route == JAIL_BWRAP;
    return ok;
}
