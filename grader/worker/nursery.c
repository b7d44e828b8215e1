// One order, one fork: the child lays its descriptors, takes its limits and goes into its jail.
#include "worker/nursery.h"

#include "base/process_child.h"
#include "jail/inside/shim_enter.h"
#include "protocol/nursery_order.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

static bool answer(int32_t pid) {
    const NurseryAnswer said = {pid};
    return send(NURSERY_SOCKET, &said, sizeof said, MSG_NOSIGNAL) == sizeof said;
}

// False when no more come.
static bool take_order(NurseryOrder *order, int descriptors[NURSERY_DESCRIPTORS]) {
    union {
        struct cmsghdr header;
        char room[CMSG_SPACE(NURSERY_DESCRIPTORS * sizeof(int))];
    } control = {0};
    struct iovec bytes = {order, sizeof *order};
    struct msghdr message = {
        .msg_iov = &bytes, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = sizeof control};
    if (recvmsg(NURSERY_SOCKET, &message, MSG_CMSG_CLOEXEC) != sizeof *order)
        return false;
    const struct cmsghdr *sent = CMSG_FIRSTHDR(&message);
    if (!sent || sent->cmsg_len != CMSG_LEN(NURSERY_DESCRIPTORS * sizeof(int)))
        return false;
    memcpy(descriptors, CMSG_DATA(sent), NURSERY_DESCRIPTORS * sizeof(int));
    return true;
}

static void lay(const int descriptors[NURSERY_DESCRIPTORS]) {
    dup2(descriptors[0], STDIN_FILENO);
    dup2(descriptors[1], STDOUT_FILENO);
    dup2(descriptors[1], STDERR_FILENO);
    dup2(descriptors[2], PROTOCOL_REPLIES);
}

static void become(NurseryOrder *order) {
    char *arguments[NURSERY_ARGUMENTS + 1] = {NULL};
    for (int i = 0; i < order->argument_count; i++)
        arguments[i] = order->arguments[i];
    signal(SIGXCPU, SIG_DFL);
    execv(arguments[0], arguments);
    shim_fail(arguments[0]);
}

// In the child.
static void begin(NurseryOrder *order, const int descriptors[NURSERY_DESCRIPTORS], const ShimOwner *owner,
                  char *const *paths, int count) {
    ShimPlan plan = {.readable_count = count + 1};
    lay(descriptors);
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL); // a grader that has gone by now has closed our descriptor 0, too
    process_child_limit(&(ProcessLimits){
        .cpu_seconds = order->cpu_seconds, .memory_mib = order->memory_mib, .file_mib = order->file_mib});
    for (int i = 0; i < count; i++)
        plan.readable[i] = paths[i];
    plan.readable[count] = order->folder;
    shim_enter(&plan, order->folder, owner);
    if (order->argument_count > 0)
        become(order);
}

bool nursery_wait(char *folder, size_t size, char *const *paths, int count) {
    static NurseryOrder order;
    const ShimOwner owner = {getuid(), getgid()};
    int descriptors[NURSERY_DESCRIPTORS];
    bool going = count < SHIM_PATHS && answer(0);
    while (going && take_order(&order, descriptors)) {
        const pid_t child = shim_enter_fork();
        if (child == 0) {
            begin(&order, descriptors, &owner, paths, count);
            snprintf(folder, size, "%s", order.folder);
            return true;
        }
        for (int i = 0; i < NURSERY_DESCRIPTORS; i++)
            close(descriptors[i]);
        memset(&order, 0, sizeof order);
        going = answer(child);
    }
    return false;
}
