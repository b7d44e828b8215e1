// A file of the system, whose lines the errors would quote.
// must: uncompiled No such file or directory
// landlock must: uncompiled Permission denied
// outside: through
#include "/etc/passwd"

static void attack(const Frame *frame) {
    (void)frame;
}
