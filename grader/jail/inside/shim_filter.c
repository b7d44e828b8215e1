// The list of allowed system calls, by libseccomp. Names that an architecture lacks are skipped.
#include "jail/inside/shim_filter.h"

#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <unistd.h>

// Memory, time, the process's own state, and files that can be seen; not uname, which tells whose machine it
// is. From version 26 on Mesa takes its memory
// by memfd_create and ftruncate: the limits on the size of a file and on descriptors hold for it.
static const char *const always[] = {"access",
                                     "arch_prctl",
                                     "brk",
                                     "clock_getres",
                                     "clock_gettime",
                                     "clock_nanosleep",
                                     "close",
                                     "close_range",
                                     "execve",
                                     "exit",
                                     "exit_group",
                                     "faccessat",
                                     "faccessat2",
                                     "fadvise64",
                                     "fstat",
                                     "ftruncate",
                                     "futex",
                                     "getcpu",
                                     "getcwd",
                                     "getdents64",
                                     "getegid",
                                     "geteuid",
                                     "getgid",
                                     "getpid",
                                     "getppid",
                                     "getrandom",
                                     "getresgid",
                                     "getresuid",
                                     "getrlimit",
                                     "getrusage",
                                     "gettid",
                                     "gettimeofday",
                                     "getuid",
                                     "lseek",
                                     "lstat",
                                     "madvise",
                                     "memfd_create",
                                     "mmap",
                                     "mprotect",
                                     "mremap",
                                     "munmap",
                                     "nanosleep",
                                     "newfstatat",
                                     "poll",
                                     "ppoll",
                                     "pread64",
                                     "read",
                                     "readlink",
                                     "readlinkat",
                                     "readv",
                                     "restart_syscall",
                                     "rseq",
                                     "rt_sigaction",
                                     "rt_sigprocmask",
                                     "rt_sigreturn",
                                     "sched_getaffinity",
                                     "sched_yield",
                                     "set_robust_list",
                                     "set_tid_address",
                                     "sigaltstack",
                                     "stat",
                                     "statx",
                                     "sysinfo",
                                     "time",
                                     "times",
                                     "write",
                                     "writev"};

// What gcc, as and ld do beyond that.
static const char *const with_children[] = {"dup",    "dup2",     "dup3",   "open",     "openat",    "pipe",
                                            "pipe2",  "pwrite64", "rename", "renameat", "renameat2", "umask",
                                            "unlink", "unlinkat", "vfork",  "wait4",    "waitid"};

static void add(scmp_filter_ctx filter, uint32_t action, const char *name, unsigned count,
                const struct scmp_arg_cmp *comparisons) {
    int number = seccomp_syscall_resolve_name(name);
    if (number == __NR_SCMP_ERROR || number < 0)
        return;
    errno = -seccomp_rule_add_array(filter, action, number, count, comparisons);
    if (errno)
        shim_fail(name);
}

static void allow(scmp_filter_ctx filter, const char *const *names, size_t count) {
    for (size_t i = 0; i < count; i++)
        add(filter, SCMP_ACT_ALLOW, names[i], 0, NULL);
}

static void allow_value(scmp_filter_ctx filter, const char *name, unsigned argument, uint64_t value) {
    add(filter, SCMP_ACT_ALLOW, name, 1, &SCMP_CMP64(argument, SCMP_CMP_EQ, value));
}

static void allow_masked(scmp_filter_ctx filter, const char *name, unsigned argument, uint64_t forbidden) {
    add(filter, SCMP_ACT_ALLOW, name, 1, &SCMP_CMP64(argument, SCMP_CMP_MASKED_EQ, forbidden, 0));
}

// Calls that are harmless with some arguments only.
static void allow_some(scmp_filter_ctx filter) {
    static const uint64_t fcntls[] = {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL};
    for (unsigned i = 0; i < sizeof fcntls / sizeof fcntls[0]; i++)
        allow_value(filter, "fcntl", 1, fcntls[i]); // F_SETOWN would send signals to others
    allow_value(filter, "ioctl", 1, TCGETS);        // isatty
    allow_value(filter, "prctl", 0, PR_SET_NAME);
    allow_value(filter, "prctl", 0, PR_GET_NO_NEW_PRIVS);
    allow_value(filter, "prctl", 0, PR_SET_SECCOMP);    // one more filter can only forbid more
    allow_value(filter, "kill", 0, (uint64_t)getpid()); // abort and the worker's report of a crash
    allow_value(filter, "tgkill", 0, (uint64_t)getpid());
    add(filter, SCMP_ACT_ALLOW, "prlimit64", 2,
        (const struct scmp_arg_cmp[]){SCMP_CMP64(0, SCMP_CMP_EQ, 0), SCMP_CMP64(2, SCMP_CMP_EQ, 0)});
    add(filter, SCMP_ACT_ERRNO(ENOSYS), "clone3", 0, NULL); // the C library falls back to clone
}

void shim_filter(const ShimPlan *plan) {
    const uint64_t namespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER |
                                CLONE_NEWPID | CLONE_NEWNET;
    const uint64_t changing = O_ACCMODE | O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY);
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
    if (!filter)
        shim_fail("seccomp");
    seccomp_attr_set(filter, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    seccomp_attr_set(filter, SCMP_FLTATR_CTL_NNP, 0);
    // Old kernels slow down every filtered process against attacks within one address space: there is only
    // one in it.
    seccomp_attr_set(filter, SCMP_FLTATR_CTL_SSB, 1);
    allow(filter, always, sizeof always / sizeof always[0]);
    allow_some(filter);
    if (plan->children) {
        allow(filter, with_children, sizeof with_children / sizeof with_children[0]);
        allow_masked(filter, "clone", 0, namespaces);
    } else {
        allow_masked(filter, "openat", 2, changing);
        allow_masked(filter, "open", 1, changing);
    }
    errno = -seccomp_load(filter);
    if (errno)
        shim_fail("seccomp");
    seccomp_release(filter);
}
