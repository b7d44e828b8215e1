// What else the grader has written to it: the next frames, as long as it draws this one.
// must: drawn
#include <poll.h>

static void attack(const Frame *frame) {
    (void)frame;
    struct pollfd input = {.fd = 0, .events = POLLIN};
    DENIED(poll(&input, 1, 50) > 0 && input.revents & POLLIN);
}
