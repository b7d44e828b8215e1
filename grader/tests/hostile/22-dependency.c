// Does a file of the machine exist, and when was it written?
// must: uncompiled No such file or directory|Permission denied
// outside: through
#pragma GCC dependency "/etc/passwd"

static void attack(const Frame *frame) {
    (void)frame;
}
