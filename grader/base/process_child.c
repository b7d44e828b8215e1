// Lays the descriptors, leaves the grader's session and user, sets the limits and becomes the program.
#include "base/process_child.h"

#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

enum { REPLY_DESCRIPTOR = 3 };

static void set_limit(int resource, rlim_t value) {
    if (value)
        setrlimit((__rlimit_resource_t)resource, &(struct rlimit){value, value});
}

void process_child_limit(const ProcessLimits *limits) {
    const rlim_t mib = 1024 * 1024;
    if (limits->cpu_seconds) // the soft limit says SIGXCPU, the hard one SIGKILL
        setrlimit(RLIMIT_CPU, &(struct rlimit){limits->cpu_seconds, limits->cpu_seconds + 1});
    set_limit(RLIMIT_AS, limits->memory_mib * mib);
    set_limit(RLIMIT_FSIZE, limits->file_mib * mib);
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
}

// A session of its own, so that nobody in it leads a group that we do not know; death with us; another user.
static void leave_us(const ProcessLimits *limits, pid_t parent) {
    bool ok = setsid() > 0;
    if (limits->user)
        ok = ok && setgroups(0, NULL) == 0 && setgid(limits->user) == 0 && setuid(limits->user) == 0;
    if (ok && prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == parent)
        return;
    dprintf(STDERR_FILENO, "a process cannot leave the grader's session or user: %s\n", strerror(errno));
    _exit(127);
}

_Noreturn void process_child_run(const int ends[3], char *const *arguments, char *const *environment,
                                 const char *folder, const ProcessLimits *limits, pid_t parent) {
    // Above the descriptors that we are about to lay, so that none is overwritten before its turn.
    int input = fcntl(ends[0], F_DUPFD, 10), output = fcntl(ends[1], F_DUPFD, 10);
    int replies = fcntl(ends[2], F_DUPFD, 10);
    dup2(input, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    dup2(replies, REPLY_DESCRIPTOR);
    close_range(REPLY_DESCRIPTOR + 1, ~0u, 0);
    signal(SIGXCPU,
           limits->untrusted ? SIG_IGN : SIG_DFL); // see hear_last_words: not for what wraps the program
    if (limits->untrusted)
        leave_us(limits, parent);
    else if (setpgid(0, 0) != 0 || prctl(PR_SET_PDEATHSIG, SIGKILL) != 0)
        _exit(127);
    if (chdir(folder) != 0) {
        dprintf(STDERR_FILENO, "%s cannot be entered: %s\n", folder, strerror(errno));
        _exit(127);
    }
    process_child_limit(limits);
    execvpe(arguments[0], arguments, environment);
    dprintf(STDERR_FILENO, "%s cannot be started: %s\n", arguments[0], strerror(errno));
    _exit(127);
}
