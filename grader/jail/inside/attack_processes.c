#include "jail/inside/attacks.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

static bool forks(const AttackTarget *target) {
    (void)target;
    pid_t pid = fork();
    if (pid == 0)
        _exit(0);
    if (pid > 0)
        waitpid(pid, NULL, 0);
    return pid > 0;
}

static void *nothing(void *context) {
    return context;
}

static bool starts_threads(const AttackTarget *target) {
    (void)target;
    pthread_t thread;
    if (pthread_create(&thread, NULL, nothing, NULL) != 0)
        return false;
    pthread_join(thread, NULL);
    return true;
}

// It would end the probe if it were possible, and then the word "probed" is missing.
static bool runs_shell(const AttackTarget *target) {
    (void)target;
    return execl("/bin/sh", "sh", "-c", "echo a shell", (char *)NULL) == 0;
}

static bool signals_others(const AttackTarget *target) {
    siginfo_t info = {.si_code = SI_QUEUE};
    return kill(target->grader, 0) == 0 || kill(getppid(), 0) == 0 || kill(0, 0) == 0 ||
           syscall(SYS_rt_sigqueueinfo, target->grader, 0, &info) == 0 ||
           fcntl(1, F_SETOWN, target->grader) == 0;
}

static bool reads_memory(const AttackTarget *target) {
    char byte;
    struct iovec here = {&byte, 1}, there = {&byte, 1};
    return ptrace(PTRACE_TRACEME, 0, NULL, NULL) == 0 ||
           ptrace(PTRACE_ATTACH, target->grader, NULL, NULL) == 0 ||
           process_vm_readv(target->grader, &here, 1, &there, 1, 0) >= 0 || errno != EPERM;
}

static bool is_root(const AttackTarget *target) {
    (void)target;
    return getuid() == 0 || geteuid() == 0 || setuid(0) == 0 || setgid(0) == 0;
}

static bool leaves_group(const AttackTarget *target) {
    (void)target;
    return setsid() >= 0 || setpgid(0, 0) == 0;
}

static bool raises_limits(const AttackTarget *target) {
    (void)target;
    struct rlimit limit;
    getrlimit(RLIMIT_NOFILE, &limit);
    return limit.rlim_max > 1024 || setrlimit(RLIMIT_NOFILE, &limit) == 0;
}

static bool uses_much_memory(const AttackTarget *target) {
    (void)target;
    return mmap(NULL, (size_t)3 << 30, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                -1, 0) != MAP_FAILED;
}

const Attack attacks_on_processes[] = {{"starting a process", forks, true, false},
                                       {"starting a thread", starts_threads, true, false},
                                       {"starting a shell", runs_shell, true, false},
                                       {"sending a signal to somebody", signals_others, false, false},
                                       {"reading somebody's memory", reads_memory, false, false},
                                       {"being root", is_root, false, false},
                                       {"leaving the process group", leaves_group, false, false},
                                       {"raising limits", raises_limits, false, false},
                                       {"using 3 GiB of memory", uses_much_memory, false, true},
                                       {0}};
