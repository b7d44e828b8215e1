// Descriptors that somebody has left open. Mesa 25 holds a file of memory, which has no name.
// must: drawn
static void attack(const Frame *frame) {
    (void)frame;
    struct stat info;
    for (int descriptor = 4; descriptor < 1024; descriptor++)
        if (fcntl(descriptor, F_GETFD) >= 0 &&
            !(fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) && info.st_nlink == 0))
            check_fail("GOT THROUGH: descriptor %d is open", descriptor);
}
