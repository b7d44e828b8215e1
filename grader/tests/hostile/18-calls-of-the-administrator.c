// System calls that change the machine, other processes, or what the kernel keeps for all of them.
// must: drawn
// outside: through
// The filter answers before the kernel looks at the arguments.
static bool answered(long number) {
    errno = 0;
    return syscall(number, -1L, -1L, -1L, -1L, -1L, -1L) >= 0 || errno != EPERM;
}

// clang-format off
static const int calls[] = {
    SYS_acct, SYS_adjtimex, SYS_capget, SYS_capset, SYS_chroot, SYS_clock_adjtime, SYS_clock_settime,
    SYS_delete_module, SYS_eventfd2, SYS_execveat, SYS_fanotify_init, SYS_finit_module, SYS_flock,
    SYS_fsconfig, SYS_fsmount, SYS_fsopen, SYS_get_mempolicy, SYS_get_robust_list, SYS_getpgid,
    SYS_getpriority, SYS_getsid, SYS_getxattr, SYS_init_module, SYS_inotify_init1, SYS_ioprio_set, SYS_kcmp,
    SYS_kexec_load, SYS_linkat, SYS_listxattr, SYS_mbind, SYS_membarrier, SYS_migrate_pages, SYS_mkdirat,
    SYS_mknodat, SYS_mlock2, SYS_mlockall, SYS_mount_setattr, SYS_move_pages, SYS_mq_open,
    SYS_name_to_handle_at, SYS_open_tree, SYS_openat2, SYS_personality, SYS_pidfd_getfd,
    SYS_pidfd_send_signal, SYS_pivot_root, SYS_pkey_alloc, SYS_preadv2, SYS_process_madvise, SYS_quotactl,
    SYS_reboot, SYS_remap_file_pages, SYS_request_key, SYS_sched_setattr, SYS_sched_setscheduler,
    SYS_semget, SYS_sendfile, SYS_set_mempolicy, SYS_setdomainname, SYS_setfsuid, SYS_setgroups,
    SYS_sethostname, SYS_setitimer, SYS_setns, SYS_setpgid, SYS_setresuid, SYS_setsid, SYS_settimeofday,
    SYS_setuid, SYS_setxattr, SYS_shmat, SYS_signalfd4, SYS_swapon, SYS_symlinkat, SYS_sync, SYS_syslog,
    SYS_tee, SYS_timerfd_create, SYS_umount2, SYS_unshare, SYS_utimensat, SYS_vhangup, SYS_vmsplice};
// clang-format on

static void attack(const Frame *frame) {
    (void)frame;
    for (unsigned i = 0; i < sizeof calls / sizeof calls[0]; i++)
        if (answered(calls[i]))
            check_fail("GOT THROUGH: system call %d", calls[i]);
}
