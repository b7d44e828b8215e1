// Functions of the worker's own names.
// must: drawn
ssize_t write(int descriptor, const void *bytes, size_t size) {
    (void)descriptor, (void)bytes;
    return (ssize_t)size;
}

bool check_fail(const char *format, ...) {
    (void)format;
    return true;
}

static void attack(const Frame *frame) {
    (void)frame;
}
