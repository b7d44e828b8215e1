// The beginning of a frame, and then nothing.
// must: timeout
static void attack(const Frame *frame) {
    (void)frame;
    const unsigned head[3] = {0x32424c53, 1, 0};
    ssize_t written = write(3, head, sizeof head);
    (void)written;
    for (;;)
        sleep(1000);
}
