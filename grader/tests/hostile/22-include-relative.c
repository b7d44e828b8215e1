// The solution, by a path that climbs.
// must: uncompiled No such file or directory
// landlock must: uncompiled Permission denied
// outside: through
#include ROOT_RELATIVE

static void attack(const Frame *frame) {
    (void)frame;
}
