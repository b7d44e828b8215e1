// A program of the system's library folders, which can be seen, in the worker's place.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    static const char *const loaders[] = {"/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1"};
    for (unsigned i = 0; i < sizeof loaders / sizeof loaders[0]; i++) {
        DENIED(OUTSIDE && access(loaders[i], X_OK) == 0);
        if (!OUTSIDE)
            execl(loaders[i], loaders[i], "--version", (char *)NULL); // would end the frame
    }
}
