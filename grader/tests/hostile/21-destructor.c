// Code that runs when the process should end, and does not let it.
// must: drawn
static void stay(void) {
    for (;;)
        sleep(1000);
}
__attribute__((destructor)) static void end(void) {
    stay();
}

static void attack(const Frame *frame) {
    (void)frame;
    atexit(stay);
}
