// Other programs.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    static const char *const programs[] = {"/bin/sh", "/usr/bin/env", "/usr/bin/python3", "/bin/busybox",
                                           "/usr/bin/gcc"};
    for (unsigned i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        DENIED(access(programs[i], X_OK) == 0 && opens(programs[i], O_RDONLY));
        if (!OUTSIDE)
            execl(programs[i], programs[i], (char *)NULL); // would end the frame
    }
    DENIED(system(NULL) != 0 && opens("/bin/sh", O_RDONLY));
}
