// An object file of 64 GiB.
// must: uncompiled does not compile
static void attack(const Frame *frame) {
    static char bytes[64ull << 30] = {1};
    frame->knobs[0] > 0 ? (void)puts(bytes) : (void)0;
}
