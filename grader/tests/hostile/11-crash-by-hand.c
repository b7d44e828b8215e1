// An exit status that looks like a signal is still no frame.
// must: lost it crashed
static void attack(const Frame *frame) {
    (void)frame;
    raise(SIGSEGV);
}
