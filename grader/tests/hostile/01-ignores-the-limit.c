// An endless loop that ignores the signal of the processor's limit.
// must: timeout
static void attack(const Frame *frame) {
    (void)frame;
    signal(SIGXCPU, SIG_IGN);
    signal(SIGTERM, SIG_IGN);
    for (volatile int i = 0;; i++)
        ;
}
