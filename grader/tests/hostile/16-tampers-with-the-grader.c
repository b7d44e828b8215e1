// The grader's memory, and signals to it and to everybody.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    char byte = 0, path[64];
    struct iovec here = {&byte, 1}, there = {(void *)(size_t)0x400000, 1};
    siginfo_t info = {.si_code = SI_QUEUE};
    DENIED(ptrace(PTRACE_SEIZE, GRADER, NULL, NULL) == 0);
    DENIED(ptrace(PTRACE_TRACEME, 0, NULL, NULL) == 0);
    DENIED(process_vm_readv(GRADER, &here, 1, &there, 1, 0) >= 0 || errno == EFAULT);
    DENIED(process_vm_writev(GRADER, &here, 0, &there, 0, 0) >= 0);
    snprintf(path, sizeof path, "/proc/%d/mem", GRADER);
    DENIED(opens(path, O_RDWR));
    snprintf(path, sizeof path, "/proc/%d/environ", GRADER);
    DENIED(opens(path, O_RDONLY));
    DENIED(kill(GRADER, 0) == 0);
    DENIED(kill(getppid(), 0) == 0);
    DENIED(kill(0, 0) == 0);
    DENIED(kill(-1, 0) == 0);
    DENIED(syscall(SYS_tkill, GRADER, 0) == 0);
    DENIED(syscall(SYS_rt_sigqueueinfo, GRADER, 0, &info) == 0);
    DENIED(syscall(SYS_pidfd_open, GRADER, 0) >= 0);
    DENIED(fcntl(1, F_SETOWN, GRADER) == 0);
    DENIED(setpriority(PRIO_PROCESS, GRADER, 19) == 0);
    DENIED(sched_setaffinity(GRADER, 0, NULL) == 0 || errno == EFAULT || errno == EINVAL);
}
