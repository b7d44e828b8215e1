// Colours that are no numbers.
// must: nan
static void attack(const Frame *frame) {
    (void)frame;
}
