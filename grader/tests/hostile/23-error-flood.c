// Errors without end.
// must: uncompiled does not compile
#define A                                                                                                    \
    wrong wrong; wrong(; ]
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
D D D D D

    static void
    attack(const Frame *frame) {
    (void)frame;
}
