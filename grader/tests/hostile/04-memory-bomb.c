// All the memory that there is, without touching it.
// must: drawn
static void attack(const Frame *frame) {
    (void)frame;
    size_t mib = 0;
    while (mib < 4096 && mmap(NULL, 64 << 20, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) != MAP_FAILED)
        mib += 64;
    DENIED(mib >= 2048);
}
