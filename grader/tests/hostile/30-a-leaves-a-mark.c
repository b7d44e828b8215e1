// Leaves a mark in its memory and its environment, for 30-b.
// must: drawn
static void attack(const Frame *frame) {
    static const char mark[] = "shadow-lab-mark ";
    enum { BYTES = 32 << 20 };
    (void)frame;
    char *heap = malloc(BYTES);
    for (int i = 0; heap && i < BYTES; i += 16)
        memcpy(heap + i, mark, 16);
    setenv("SHADOW_LAB_MARK", mark, 1);
}
