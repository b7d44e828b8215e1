// Code that runs when the library is loaded.
// must: lost it ended by itself with exit status 7
__attribute__((constructor)) static void begin(void) {
    _exit(7);
}

static void attack(const Frame *frame) {
    (void)frame;
}
