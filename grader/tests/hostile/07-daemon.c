// A process that leaves its parent and its session and stays.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    DENIED(setsid() >= 0);
    DENIED(setpgid(0, 0) == 0);
    DENIED(daemon(0, 0) == 0);
    pid_t pid = fork();
    if (pid == 0) {
        setsid();
        sleep(2);
        _exit(0);
    }
    DENIED(pid > 0);
}
