// An expression that is nested deeper than the compiler's stack.
// must: uncompiled does not compile
#define A(x) (((((((((((((((((((x))))))))))))))))))))
#define B(x) A(A(A(A(A(A(A(A(A(A(x))))))))))
#define C(x) B(B(B(B(B(B(B(B(B(B(x))))))))))
#define D(x) C(C(C(C(C(C(C(C(C(C(x))))))))))
#define E(x) D(D(D(D(D(D(D(D(D(D(x))))))))))
static int deep = E(1);

static void attack(const Frame *frame) {
    (void)frame;
    UNUSED(deep);
}
