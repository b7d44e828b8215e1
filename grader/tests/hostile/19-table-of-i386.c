// A system call by the table of another architecture.
// must: lost it crashed: Bad system call
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
#if defined(__x86_64__)
    long result;
    __asm__ volatile("int $0x80" : "=a"(result) : "a"(20) : "memory", "r8", "r9", "r10", "r11");
    DENIED(result > 0);
#else
    raise(SIGSYS);
#endif
}
