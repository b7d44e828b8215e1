// What stands at a TODO: as it was handed out, written below or above it, or nobody knows whose.
#include "diagnose/task_text.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static const char skeleton[] = "float f(float x) {\n"
                               "    float y = x;\n"
                               "    // TODO(1.1): double y.\n"
                               "    // Twice.\n"
                               "    // TODO(1.2): nothing below 0.\n"
                               "    return y;\n"
                               "}\n"
                               "void g() {\n"
                               "    // TODO(1.1), second part: call f.\n"
                               "}\n";

static void expect(const char *text, int number, const char *mark, TaskText wanted) {
    const char *at = strstr(text, mark);
    for (int i = 1; i < number && at; i++)
        at = strstr(at + 1, mark);
    assert_non_null(at);
    assert_int_equal(task_text_compare(text, at, mark, skeleton), wanted);
}

static void test_untouched(void **unused) {
    (void)unused;
    expect(skeleton, 1, "TODO(1.1)", TASK_TEXT_HANDED_OUT);
    expect(skeleton, 2, "TODO(1.1)", TASK_TEXT_HANDED_OUT);
    expect(skeleton, 1, "TODO(1.2)", TASK_TEXT_HANDED_OUT);
    expect("float f(float x) { float y = x; // TODO(1.1)\n\n/* a note */ // TODO(1.2)\n return y; }", 1,
           "TODO(1.2)", TASK_TEXT_HANDED_OUT);
}

static void test_below(void **unused) {
    (void)unused;
    static const char text[] =
        "float f(float x) {\n float y = x;\n // TODO(1.1)\n y = y + 0.0;\n // TODO(1.2)\n"
        " return y;\n}\nvoid g() {\n // TODO(1.1), second part\n f(1.0);\n}\n";
    expect(text, 1, "TODO(1.1)", TASK_TEXT_WRITTEN);
    expect(text, 2, "TODO(1.1)", TASK_TEXT_WRITTEN);
    expect(text, 1, "TODO(1.2)", TASK_TEXT_HANDED_OUT);
}

static void test_above(void **unused) {
    (void)unused;
    static const char text[] = "float f(float x) {\n float y = x;\n y = 2.0 * y;\n // TODO(1.1)\n"
                               " if (y < 0.0) y = 0.0;\n // TODO(1.2)\n return y;\n}\n"
                               "void g() {\n f(1.0);\n // TODO(1.1)\n}\n";
    expect(text, 1, "TODO(1.1)", TASK_TEXT_WRITTEN);
    expect(text, 2, "TODO(1.1)", TASK_TEXT_WRITTEN);
    expect(text, 1, "TODO(1.2)", TASK_TEXT_WRITTEN);
}

// The other TODO is gone: its code stands where that of this task would.
static void test_unknown(void **unused) {
    (void)unused;
    expect("float f(float x) {\n float y = x;\n // TODO(1.1)\n if (y < 0.0) y = 0.0;\n return y;\n}\n", 1,
           "TODO(1.1)", TASK_TEXT_UNKNOWN);
    expect("float other(float x) {\n // TODO(1.1)\n return x;\n}\n", 1, "TODO(1.1)", TASK_TEXT_UNKNOWN);
}

// The other TODO is gone, but what stood below this one is, too.
static void test_replaced(void **unused) {
    (void)unused;
    expect("float f(float x) {\n float y = x;\n // TODO(1.2)\n return max(y, 0.0);\n}\n", 1, "TODO(1.2)",
           TASK_TEXT_WRITTEN);
}

// Two TODOs stand on each other, and the answers of one or both below the second.
static void test_either(void **unused) {
    (void)unused;
    static const char both[] = "float f(float x) {\n float y = x;\n // TODO(1.1)\n // TODO(1.2)\n"
                               " y = 2.0 * y;\n return max(y, 0.0);\n}\nvoid g() {\n // TODO(1.1)\n}\n";
    expect(both, 1, "TODO(1.1)", TASK_TEXT_EITHER);
    expect(both, 1, "TODO(1.2)", TASK_TEXT_EITHER);
    expect(both, 2, "TODO(1.1)", TASK_TEXT_HANDED_OUT);
    static const char each[] =
        "float f(float x) {\n float y = x;\n // TODO(1.1)\n y = 2.0 * y;\n // TODO(1.2)\n"
        " return max(y, 0.0);\n}\n";
    expect(each, 1, "TODO(1.1)", TASK_TEXT_WRITTEN);
    expect(each, 1, "TODO(1.2)", TASK_TEXT_WRITTEN);
}

// The places around a TODO where people write while its mark stays, each in a function of two tasks with
// words that were given between them.
static void test_places(void **unused) {
    (void)unused;
    static const char handed_out[] = "float f(float x) {\n float y = x;\n // TODO(1.1): double y.\n"
                                     " float z = y;\n // TODO(1.2): nothing below 0.\n return z;\n}\n";
    static const TaskText NO = TASK_TEXT_HANDED_OUT, YES = TASK_TEXT_WRITTEN, MAYBE = TASK_TEXT_EITHER,
                          NOBODY_KNOWS = TASK_TEXT_UNKNOWN;
    const struct {
        const char *body;
        TaskText first, second;
    } cases[] = {
        {"float y = x; // TODO(1.1)\n float z = y; // TODO(1.2)\n return z;", NO, NO},
        {"float y = x; // TODO(1.1)\n y *= 2.0; float z = y; // TODO(1.2)\n return z;", YES, NO},
        {"float y = x; y *= 2.0; // TODO(1.1)\n float z = y; // TODO(1.2)\n return z;", YES, NO},
        {"float y = x; // TODO(1.1)\n float z = y; // TODO(1.2)\n z = max(z, 0.0); return z;", NO, YES},
        {"float y = x; // TODO(1.1)\n y *= 2.0; float z = y; // TODO(1.2)\n z = max(z, 0.0); return z;", YES,
         YES},
        {"float y = x; y *= 2.0; // TODO(1.1)\n float z = y; z = max(z, 0.0); // TODO(1.2)\n return z;", YES,
         YES},
        {"float y = x; y *= 2.0; // TODO(1.1)\n float z = y; // TODO(1.2)\n z = max(z, 0.0); return z;",
         MAYBE, YES},
        {"float y = x; // TODO(1.1)\n y *= 2.0; float z = y; z = max(z, 0.0); // TODO(1.2)\n return z;", YES,
         MAYBE},
        {"float y = x; y *= 2.0; float z = y; z = max(z, 0.0); // TODO(1.2)\n return z;", YES, MAYBE},
        {"float y = x; y *= 2.0; float z = y; // TODO(1.2)\n return z;", YES, NO},
        {"float y = x; // TODO(1.1)\n float z = y; return max(z, 0.0);", NOBODY_KNOWS, YES},
        {"float y = x; y *= 2.0; // TODO(1.1)\n float z = y; z = max(z, 0.0); return z;", MAYBE, YES},
        {"float y = x; /* TODO(1.1) */ y *= 2.0; float z = y; /* TODO(1.2) */ return z;", YES, NO},
        {"// TODO(1.1)\n float y = 2.0 * x; float z = y; // TODO(1.2)\n return z;", YES, NO},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static const char *const marks[] = {"TODO(1.1)", "TODO(1.2)"};
        char text[300];
        snprintf(text, sizeof text, "float f(float x) { %s\n}\n", cases[i].body);
        for (int m = 0; m < 2; m++) {
            const char *at = strstr(text, marks[m]);
            const TaskText wanted = m ? cases[i].second : cases[i].first;
            if (at && task_text_compare(text, at, marks[m], handed_out) != wanted)
                fail_msg("%s in: %s", marks[m], cases[i].body);
        }
    }
}

// The answer of a TODO outside of functions is a function of its own.
static void test_function_written(void **unused) {
    (void)unused;
    static const char handed_out[] =
        "int a;\n// TODO(2.1): a function.\n// TODO(2.2): one more.\nvoid main() {\n}\n";
    static const char text[] = "int a;\n// TODO(2.1)\nvoid one() {\n}\n// TODO(2.2)\nvoid main() {\n}\n";
    assert_int_equal(task_text_compare(text, strstr(text, "TODO(2.1)"), "TODO(2.1)", handed_out),
                     TASK_TEXT_WRITTEN);
    assert_int_equal(task_text_compare(text, strstr(text, "TODO(2.2)"), "TODO(2.2)", handed_out),
                     TASK_TEXT_HANDED_OUT);
    assert_int_equal(task_text_compare(handed_out, strstr(handed_out, "TODO(2.1)"), "TODO(2.1)", handed_out),
                     TASK_TEXT_HANDED_OUT);
}

static void test_put_before(void **unused) {
    (void)unused;
    static const char without[] = "float f() {\n // TODO(1.1)\n return y;\n}\n";
    static const char text[] = "float f() {\n // TODO(1.1)\n y = y + 0.0;\n return y;\n}\n";
    static const char other[] = "float f() {\n // TODO(1.1)\n return y + y;\n}\n";
    assert_true(task_text_put_before(text, strstr(text, "TODO"), "TODO(1.1)", without));
    assert_false(task_text_put_before(without, strstr(without, "TODO"), "TODO(1.1)", without));
    assert_false(task_text_put_before(other, strstr(other, "TODO"), "TODO(1.1)", without));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_untouched), cmocka_unit_test(test_below),
        cmocka_unit_test(test_above),     cmocka_unit_test(test_unknown),
        cmocka_unit_test(test_replaced),  cmocka_unit_test(test_put_before),
        cmocka_unit_test(test_either),    cmocka_unit_test(test_function_written),
        cmocka_unit_test(test_places)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
