// No frame, and the pipe is closed.
// must: timeout
static void attack(const Frame *frame) {
    (void)frame;
    close(3);
    close(1);
    close(2);
    for (;;)
        sleep(1000);
}
