// The file into which the grader writes the result, which anybody may write to.
// must: drawn
// outside: through
static void attack(const Frame *frame) {
    (void)frame;
    DENIED(opens(RESULT, O_WRONLY));
    DENIED(opens(RESULT, O_RDONLY | O_TRUNC));
    DENIED(truncate(RESULT, 0) == 0);
    DENIED(rename("lab.c", RESULT) == 0);
    DENIED(link("lab.c", RESULT ".link") == 0);
}
