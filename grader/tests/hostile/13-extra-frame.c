// Bytes before the frame.
// must: lost it wrote something else than a frame to descriptor 3
static void attack(const Frame *frame) {
    (void)frame;
    ssize_t written = write(3, "0123456789abcdef", 16);
    (void)written;
}
