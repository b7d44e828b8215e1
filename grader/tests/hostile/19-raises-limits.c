// Its own limits, and another user.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    struct rlimit files, stack;
    getrlimit(RLIMIT_NOFILE, &files);
    getrlimit(RLIMIT_STACK, &stack);
    DENIED(files.rlim_max > 64);
    DENIED(setrlimit(RLIMIT_NOFILE, &files) == 0);
    DENIED(setrlimit(RLIMIT_STACK, &stack) == 0);
    DENIED(setrlimit(RLIMIT_CPU, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY}) == 0);
    DENIED(prlimit(GRADER, RLIMIT_NOFILE, NULL, &files) == 0);
    DENIED(setuid(0) == 0 || setuid(getuid()) == 0);
    DENIED(getuid() == 0 || geteuid() == 0);
    DENIED(nice(-5) != -1);
}
