// It sleeps, and uses no processor time.
// must: timeout
static void attack(const Frame *frame) {
    (void)frame;
    for (;;)
        sleep(1000);
}
