// An endless loop.
// must: timeout
static void attack(const Frame *frame) {
    (void)frame;
    for (volatile int i = 0;; i++)
        ;
}
