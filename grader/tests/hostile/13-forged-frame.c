// A whole answer of its own: it is taken like any frame, but its times must not spoil the report.
// must: drawn
static void send_all(const void *bytes, size_t size) {
    for (size_t done = 0; done < size;) {
        ssize_t n = write(3, (const char *)bytes + done, size - done);
        if (n <= 0)
            _exit(1);
        done += (size_t)n;
    }
}

static void attack(const Frame *frame) {
    static ForgedReply reply = {.magic = 0x32424c53, .drawn = 1, .place = 1};
    static unsigned char pixels[1 << 16];
    for (int i = 0; i < LAB_MAX_PASSES; i++)
        reply.milliseconds[i] = reply.gpu_milliseconds[i] = i == 0 ? NAN : i == 1 ? -1 : INFINITY;
    memset(reply.renderer, 'x', sizeof reply.renderer);
    memset(pixels, 255, sizeof pixels);
    send_all(&reply, sizeof reply);
    send_all(pixels, (size_t)frame->width * (size_t)frame->height * 4);
    _exit(0);
}
