#include "jail/inside/attacks.h"

#include <errno.h>
#include <mqueue.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

static bool opens_sockets(const AttackTarget *target) {
    static const int families[] = {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK};
    int pair[2];
    (void)target;
    for (unsigned i = 0; i < sizeof families / sizeof families[0]; i++)
        if (socket(families[i], SOCK_STREAM, 0) >= 0 || errno != EPERM)
            return true;
    return socketpair(AF_UNIX, SOCK_STREAM, 0, pair) == 0;
}

static bool makes_namespaces(const AttackTarget *target) {
    (void)target;
    return unshare(CLONE_NEWUSER) == 0 || unshare(CLONE_NEWNS) == 0 ||
           syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, NULL, NULL, NULL, NULL) >= 0;
}

// A kernel that lacks one of them answers ENOSYS, but the filter comes first.
static bool calls_kernel(const AttackTarget *target) {
    static const long calls[] = {SYS_io_uring_setup, SYS_bpf,         SYS_keyctl,
                                 SYS_add_key,        SYS_userfaultfd, SYS_perf_event_open,
                                 SYS_pidfd_open,     SYS_init_module, SYS_kexec_load,
                                 SYS_reboot,         SYS_setns,       SYS_process_vm_writev,
                                 SYS_kcmp,           SYS_quotactl,    SYS_syslog};
    (void)target;
    for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++)
        if (syscall(calls[i], 0, 0, 0, 0, 0, 0) >= 0 || errno != EPERM)
            return true;
    return personality(ADDR_NO_RANDOMIZE) != -1;
}

// What gets through is removed again.
static bool shares_memory(const AttackTarget *target) {
    (void)target;
    int memory = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600), queue = msgget(IPC_PRIVATE, IPC_CREAT | 0600);
    int file = shm_open("/shadow-lab-attack", O_CREAT | O_RDWR, 0600);
    mqd_t named = mq_open("/shadow-lab-attack", O_CREAT | O_RDWR, 0600, NULL);
    shmctl(memory, IPC_RMID, NULL);
    msgctl(queue, IPC_RMID, NULL);
    shm_unlink("/shadow-lab-attack");
    mq_unlink("/shadow-lab-attack");
    return memory >= 0 || queue >= 0 || file >= 0 || named != (mqd_t)-1;
}

// Mesa needs such files; more than file_mib of the self-test, 1 MiB, must not fit into one. The signal of a
// file that grows too large would end us.
static bool fills_memory(const AttackTarget *target) {
    (void)target;
    enum { MIB = 1 << 20 };
    signal(SIGXFSZ, SIG_IGN);
    int file = memfd_create("attack", 0);
    bool grows = file >= 0 && (ftruncate(file, 2 * MIB) == 0 || lseek(file, 2 * MIB, SEEK_SET) < 0 ||
                               write(file, "x", 1) == 1);
    close(file);
    return grows;
}

static bool may_gain_privileges(const AttackTarget *target) {
    (void)target;
    return prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) != 1;
}

const Attack attacks_on_kernel[] = {{"opening a socket", opens_sockets, false, false},
                                    {"making a namespace", makes_namespaces, false, false},
                                    {"a system call that nobody needs", calls_kernel, false, false},
                                    {"shared memory or a message queue", shares_memory, false, false},
                                    {"a large file in memory", fills_memory, false, false},
                                    {"gaining privileges", may_gain_privileges, false, false},
                                    {0}};

void attack_by_other_architecture(void) {
#if defined(__x86_64__)
    enum { I386_GETPID = 20 };
    long result;
    __asm__ volatile("int $0x80" : "=a"(result) : "a"(I386_GETPID) : "memory", "r8", "r9", "r10", "r11");
    printf("system calls of another architecture (%ld)\n", result);
    fflush(stdout);
#endif
}
