// Starts the nursery once a process, tries our attacks in one of its children, and gives it orders.
#include "exam/nursery_client.h"

#include "base/process_child.h"
#include "jail/bwrap_command.h"
#include "jail/jail.h"
#include "jail/self_test.h"
#include "protocol/nursery_order.h"
#include "scene/check.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

enum { PATIENCE = 10000 }; // milliseconds

static struct {
    pid_t owner; // whose nursery it is: a fork of ours has none
    pid_t pid;   // 0: none
    int socket;
    int asked;
    bool broken; // there will be none
    const Jail *jail;
    ContextKind context;
} nursery;

#if defined(__SANITIZE_ADDRESS__)
static const bool can_fork = false; // the sanitizer's memory has no place under the limits
#else
static const bool can_fork = true;
#endif

static bool hear(NurseryAnswer *answer) {
    return poll(&(struct pollfd){.fd = nursery.socket, .events = POLLIN}, 1, PATIENCE) > 0 &&
           recv(nursery.socket, answer, sizeof *answer, 0) == sizeof *answer;
}

static bool send_order(const NurseryOrder *order, const int theirs[NURSERY_DESCRIPTORS]) {
    union {
        struct cmsghdr header;
        char room[CMSG_SPACE(NURSERY_DESCRIPTORS * sizeof(int))];
    } control = {0};
    struct iovec bytes = {(void *)order, sizeof *order};
    struct msghdr message = {
        .msg_iov = &bytes, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = sizeof control};
    control.header = (struct cmsghdr){.cmsg_level = SOL_SOCKET,
                                      .cmsg_type = SCM_RIGHTS,
                                      .cmsg_len = CMSG_LEN(NURSERY_DESCRIPTORS * sizeof(int))};
    memcpy(CMSG_DATA(&control.header), theirs, NURSERY_DESCRIPTORS * sizeof(int));
    return sendmsg(nursery.socket, &message, MSG_NOSIGNAL) == sizeof *order;
}

bool nursery_stop(void) {
    const bool runs = nursery.owner == getpid() && nursery.pid > 0;
    if (runs) {
        kill(nursery.pid, SIGKILL);
        waitpid(nursery.pid, NULL, 0);
        close(nursery.socket);
    }
    nursery.pid = 0;
    return runs;
}

// Starts a child with these arguments, or, without, a worker.
static bool order_child(const JailPlan *plan, Process *process, char *const *arguments) {
    static NurseryOrder order;
    NurseryAnswer answer = {-1};
    int theirs[3];
    order = (NurseryOrder){.cpu_seconds = plan->limits.cpu_seconds,
                           .memory_mib = plan->limits.memory_mib,
                           .file_mib = plan->limits.file_mib};
    bool fits = snprintf(order.folder, PROTOCOL_PATH, "%s", plan->folder) < PROTOCOL_PATH;
    for (int i = 0; arguments && arguments[i]; i++, order.argument_count++)
        fits = fits && i < NURSERY_ARGUMENTS &&
               snprintf(order.arguments[i], PROTOCOL_PATH, "%s", arguments[i]) < PROTOCOL_PATH;
    if (!fits || !process_open(process, theirs, &plan->limits))
        return false;
    if (!send_order(&order, theirs) || !hear(&answer))
        nursery.broken = true;
    errno = EAGAIN;
    const bool ok = process_opened(process, theirs, answer.pid);
    process->wrapped = ok;
    return ok;
}

static bool order_probe(const Jail *jail, const JailPlan *plan, Process *process, char *const *arguments,
                        char *const *environment) {
    (void)environment; // that of the nursery
    return jail_lend(jail, plan) && order_child(plan, process, arguments);
}

static pid_t fork_nursery(const Jail *jail, ContextKind context, int end, char *const *environment) {
    BwrapCommand paths;
    char worker[FILES_PATH], shaders[FILES_PATH];
    const ProcessLimits limits = {.untrusted = true, .user = jail->user};
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const pid_t parent = getpid();
    jail_part(jail, "worker", worker);
    jail_part(jail, "shaders", shaders);
    bwrap_command_nursery(&paths, jail,
                          (char *[]){worker, (char *)context_name(context), (char *)"?", shaders, NULL});
    const pid_t pid = nothing >= 0 ? fork() : -1;
    if (pid == 0)
        process_child_run((int[]){end, nothing, end}, paths.arguments, environment, "/", &limits, parent);
    close(nothing);
    return pid;
}

// In a child of it our own attacks must fail as they do in the jail that is made in the usual way.
static void open_nursery(const Jail *jail, ContextKind context, char *const *environment) {
    int ends[2];
    NurseryAnswer ready = {-1};
    nursery_stop();
    nursery.broken = true;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return;
    nursery.pid = fork_nursery(jail, context, ends[1], environment);
    nursery.owner = getpid();
    nursery.jail = jail;
    nursery.context = context;
    nursery.socket = ends[0];
    close(ends[1]);
    nursery.broken = nursery.pid <= 0 || !hear(&ready) || ready.pid != 0;
    nursery.broken = nursery.broken || !self_test_of(jail, JAIL_DRAW, order_probe) || nursery.broken;
    if (nursery.broken)
        nursery_stop();
}

bool nursery_start(const Jail *jail, ContextKind context, const JailPlan *plan, Process *process,
                   char *const *environment) {
    if (!can_fork || jail->route != JAIL_BWRAP)
        return false;
    const bool ours = nursery.owner == getpid();
    if (!ours)
        nursery.pid = 0, nursery.asked = 0, nursery.broken = false, nursery.owner = getpid();
    if (++nursery.asked == 1 || nursery.broken)
        return false;
    if (nursery.pid <= 0 || nursery.jail != jail || nursery.context != context)
        open_nursery(jail, context, environment);
    const bool ok = !nursery.broken && jail_lend(jail, plan) && order_child(plan, process, NULL);
    if (!ok)
        check_clear();
    return ok;
}
