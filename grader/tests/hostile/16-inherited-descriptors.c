// Descriptors that the grader, or who started it, has left open.
// must: drawn
static void attack(const Frame *frame) {
    (void)frame;
    for (int descriptor = 4; descriptor < 1024; descriptor++)
        if (fcntl(descriptor, F_GETFD) >= 0)
            check_fail("GOT THROUGH: descriptor %d is open", descriptor);
}
