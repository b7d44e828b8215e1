// A program that it has written into memory.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    static const char script[] = "#!/bin/sh\nexit 3\n";
    int file = (int)syscall(SYS_memfd_create, "program", 0);
    DENIED(OUTSIDE && file >= 0);
    if (OUTSIDE || file < 0)
        return;
    char *const none[] = {NULL};
    if (write(file, script, sizeof script - 1) > 0) {
        syscall(SYS_execveat, file, "", none, none, 0x1000); // would end the frame
        execve("/proc/self/fd/4", none, none);
    }
    close(file);
}
