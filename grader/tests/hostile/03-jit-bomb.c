// A shader that grows in the compiler: 4^7 statements from seven macros.
// must: timeout
static void attack(const Frame *frame) {
    (void)frame;
}
