// The last record of a crash by hand, with a name of a pass that does not end and bytes for a terminal.
// Then a crash: the text is cut and cleaned.
//
// must: lost it crashed: Aborted (ABRT) in ?[2J???
static void attack(const Frame *frame) {
    static ForgedReply reply = {.magic = 0x58424c53, .place = ~0ull};
    (void)frame;
    memset(&reply.pass, 255, sizeof reply - offsetof(__typeof__(reply), pass));
    memcpy(reply.pass, "\x1b[2J", 4);
    if (write(3, &reply, sizeof reply) != sizeof reply)
        _exit(1);
    signal(SIGABRT, SIG_DFL);
    abort();
}
