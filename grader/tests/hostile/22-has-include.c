// Is the solution there?
// must: drawn
// landlock must: uncompiled Permission denied
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
#if __has_include(ROOT_SOLUTION) || __has_include(ROOT_RELATIVE) || __has_include("/etc/passwd")
    check_fail("GOT THROUGH: __has_include");
#endif
}
