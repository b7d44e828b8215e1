// The solution's lines, by the assembler.
// must: uncompiled can't open
__asm__(".include " QUOTED_SOLUTION);

static void attack(const Frame *frame) {
    (void)frame;
}
