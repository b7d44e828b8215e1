// Code that runs while the library is linked, before anything else of it.
// must: lost it ended by itself with exit status 9
static void *resolve(void) {
    _exit(9);
}
void chosen(void) __attribute__((ifunc("resolve")));

static void attack(const Frame *frame) {
    (void)frame;
    chosen();
}
