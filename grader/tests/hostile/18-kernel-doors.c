// System calls in which kernels had their holes.
// must: drawn
// outside: through
// The filter answers before the kernel looks at the arguments.
static bool answered(long number) {
    errno = 0;
    return syscall(number, 0, 0, 0, 0, 0, 0) >= 0 || errno != EPERM;
}

static void attack(const Frame *frame) {
    (void)frame;
    char block[128] = {0};
    DENIED(syscall(SYS_io_uring_setup, 1, block) >= 0);
    DENIED(answered(SYS_io_uring_setup));
    DENIED(answered(SYS_bpf));
    DENIED(answered(SYS_keyctl));
    DENIED(answered(SYS_add_key));
    DENIED(answered(SYS_userfaultfd));
    DENIED(answered(SYS_perf_event_open));
    DENIED(answered(SYS_mount));
    DENIED(answered(SYS_move_mount));
    DENIED(answered(SYS_setns));
    DENIED(answered(SYS_open_by_handle_at));
    DENIED(answered(SYS_epoll_create1));
    DENIED(answered(SYS_timer_create));
    DENIED(answered(SYS_splice));
    DENIED(answered(SYS_landlock_create_ruleset));
    DENIED(unshare(CLONE_NEWUSER) == 0);
    DENIED(unshare(CLONE_NEWNET) == 0);
    DENIED(chroot(".") == 0);
    int memory = shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600);
    int queue = msgget(IPC_PRIVATE, IPC_CREAT | 0600);
    DENIED(memory >= 0);
    DENIED(queue >= 0);
    shmctl(memory, IPC_RMID, NULL);
    msgctl(queue, IPC_RMID, NULL);
}
