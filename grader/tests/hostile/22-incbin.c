// The solution's bytes, by the assembler.
// must: uncompiled file not found
// outside: through
__asm__(".section .rodata\nstolen: .incbin " QUOTED_SOLUTION "\n.previous");

static void attack(const Frame *frame) {
    (void)frame;
}
