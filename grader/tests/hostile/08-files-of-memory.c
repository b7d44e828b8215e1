// Files that lie in memory, beside the limit of addresses: only small ones, and few of them.
// must: drawn
static void attack(const Frame *frame) {
    (void)frame;
    int descriptors[256], count = 0, large;
    signal(SIGXFSZ, SIG_IGN);
    while (count < 256 && (descriptors[count] = (int)syscall(SYS_memfd_create, "bomb", 0)) >= 0)
        count++;
    DENIED(count > 64);
    large = count > 0 ? descriptors[0] : -1;
    DENIED(ftruncate(large, 2 << 20) == 0);
    DENIED(lseek(large, 2 << 20, SEEK_SET) > 0 && write(large, "x", 1) == 1);
    DENIED(syscall(SYS_fallocate, large, 0, 0L, 2L << 20) == 0);
    for (int i = 0; i < count; i++)
        close(descriptors[i]);
}
