// Files, wherever one might be made.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    static const char *const folders[] = {".",        "..",   "/",     "/tmp", "/var/tmp",
                                          "/dev/shm", "/run", "/home", FOLDER};
    for (unsigned i = 0; i < sizeof folders / sizeof folders[0]; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/shadow-lab-hostile", folders[i]);
        DENIED(opens(path, O_WRONLY | O_CREAT));
        DENIED(opens(folders[i], O_TMPFILE | O_RDWR));
        DENIED(mkdir(path, 0700) == 0);
        DENIED(symlink(SECRET, path) == 0);
        unlink(path);
        rmdir(path);
    }
    DENIED(fallocate(1, 0, 0, 1 << 30) == 0);
    DENIED(opens("lab.c", O_RDONLY | O_TRUNC));
    DENIED(opens("lab.so", O_RDWR));
    DENIED(chmod("lab.c", 0777) == 0);
}
