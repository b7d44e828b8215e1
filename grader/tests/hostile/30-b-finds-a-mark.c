// Looks for what 30-a has left: in memory that it is given, and in its environment.
// must: drawn
static bool is_mark(const char *at) {
    static const char turned[] =
        "ri`env,m`c,l`sj"; // each character with another lowest bit: not the mark itself
    for (int i = 0; i < 15; i++)
        if (at[i] != (turned[i] ^ 1))
            return false;
    return true;
}

static void attack(const Frame *frame) {
    enum { BYTES = 48 << 20 };
    bool found = false;
    (void)frame;
    const char *heap = malloc(BYTES);
    for (int i = 0; heap && i < BYTES - 16; i++)
        found = found || is_mark(heap + i);
    DENIED(found);
    DENIED(getenv("SHADOW_LAB_MARK"));
}
