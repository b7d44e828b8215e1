// The solution, by its absolute path.
// must: uncompiled No such file or directory
// landlock must: uncompiled Permission denied
// outside: through
#include ROOT_SOLUTION

static void attack(const Frame *frame) {
    (void)frame;
}
