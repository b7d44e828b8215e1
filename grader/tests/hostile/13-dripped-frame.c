// A frame, one byte at a time.
// must: timeout
static void attack(const Frame *frame) {
    (void)frame;
    while (write(3, "S", 1) == 1)
        usleep(5000);
}
