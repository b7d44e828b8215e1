// Does the solution exist, and when was it written?
// must: uncompiled No such file or directory|Permission denied
// outside: through
#pragma GCC dependency ROOT_SOLUTION

static void attack(const Frame *frame) {
    (void)frame;
}
