// A system call by the table of x32.
// must: lost it crashed: Bad system call
static void attack(const Frame *frame) {
    (void)frame;
#if defined(__x86_64__)
    DENIED(syscall(0x40000000 | SYS_getpid) > 0);
#else
    raise(SIGSYS);
#endif
}
