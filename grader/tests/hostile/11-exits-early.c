// An end before the frame.
// must: lost it ended by itself with exit status 0
static void attack(const Frame *frame) {
    (void)frame;
    exit(0);
}
