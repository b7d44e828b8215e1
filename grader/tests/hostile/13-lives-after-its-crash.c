// The record of a crash, and then pixels as if nothing had been: no frame comes after a crash.
// must: lost it wrote something else than a frame to descriptor 3
static void attack(const Frame *frame) {
    static ForgedReply reply = {.magic = 0x58424c53, .drawn = 1};
    static unsigned char pixels[1 << 16];
    const ssize_t size = (ssize_t)frame->width * frame->height * 4;
    memset(pixels, 255, sizeof pixels);
    if (write(3, &reply, sizeof reply) != sizeof reply || write(3, pixels, (size_t)size) != size)
        _exit(1);
    for (;;)
        pause();
}
