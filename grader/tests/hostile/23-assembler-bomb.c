// An object file of gigabytes, by one line for the assembler.
// must: uncompiled does not compile
__asm__(".data\n.fill 0x7fffffff, 1, 1\n.text");

static void attack(const Frame *frame) {
    (void)frame;
}
