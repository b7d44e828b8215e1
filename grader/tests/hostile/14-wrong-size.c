// A frame of another size.
// must: drawn
static void attack(const Frame *frame) {
    int *size = (int *)&frame->width;
    size[0] = 4096;
    size[1] = 4096;
}
