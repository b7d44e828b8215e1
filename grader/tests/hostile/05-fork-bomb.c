// Processes, by each call that makes one.
// must: drawn
// outside: through
static bool child(long pid) {
    if (pid == 0)
        _exit(0);
    return pid > 0;
}

static void attack(const Frame *frame) {
    (void)frame;
    DENIED(child(fork()));
    DENIED(child(syscall(SYS_clone, SIGCHLD, NULL, NULL, NULL, NULL)));
    DENIED(child(syscall(SYS_clone, CLONE_PARENT | SIGCHLD, NULL, NULL, NULL, NULL)));
    struct {
        unsigned long long flags, rest[10];
    } arguments = {0};
    DENIED(child(syscall(SYS_clone3, &arguments, 64)));
    DENIED(system("true") == 0);
    DENIED(popen("true", "r") != NULL);
}
