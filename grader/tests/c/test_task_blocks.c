// The one annotated source: what comes out of the markers, and what is refused.
#include "compile/task_blocks.h"

#include "scene/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char TEXT[] = "a\n"
                           "#ifdef SOLUTION // 3.1\n"
                           "one\n"
                           "#else\n"
                           "TODO(3.1)\n"
                           "#endif\n"
                           "#ifdef SOLUTION // 3.10\n"
                           "#if X\n"
                           "ten\n"
                           "#else\n"
                           "X\n"
                           "#endif\n"
                           "#endif\n"
                           "b\n";

static void expect(Solved solved, bool keep_lines, const char *expected) {
    char *text = task_blocks_select("file.c", TEXT, solved, keep_lines);
    assert_non_null(text);
    assert_string_equal(text, expected);
    free(text);
}

static void test_select(void **unused) {
    (void)unused;
    expect((Solved){SOLVED_ALL, NULL}, false, "a\none\n#if X\nten\n#else\nX\n#endif\nb\n");
    expect((Solved){SOLVED_NONE, NULL}, false, "a\nTODO(3.1)\nb\n");
    expect((Solved){SOLVED_ALL_BUT, "3.1"}, false, "a\nTODO(3.1)\n#if X\nten\n#else\nX\n#endif\nb\n");
    expect((Solved){SOLVED_ALL_BUT, "3"}, false, "a\nTODO(3.1)\nb\n");
    expect((Solved){SOLVED_UP_TO, "3.2"}, false, "a\none\nb\n");
    expect((Solved){SOLVED_UP_TO, "3.10"}, false, "a\none\n#if X\nten\n#else\nX\n#endif\nb\n");
}

static void test_lines_stay_true(void **unused) {
    (void)unused;
    expect((Solved){SOLVED_ALL, NULL}, true, "a\n\none\n\n\n\n\n#if X\nten\n#else\nX\n#endif\n\nb\n");
}

static void refuse(const char *text, const char *message) {
    check_clear();
    assert_null(task_blocks_select("file.c", text, (Solved){SOLVED_ALL, NULL}, false));
    assert_non_null(strstr(check_message(), message));
}

static void test_refused(void **unused) {
    (void)unused;
    refuse("x\n#ifdef SOLUTION // 3.1\ny\n", "file.c:2: this SOLUTION block has no #endif");
    refuse("#ifdef SOLUTION\ny\n#endif\n", "file.c:1: expected a task id");
    refuse("#ifdef SOLUTION // 3.1\n#ifdef SOLUTION // 3.2\n#endif\n#endif\n",
           "file.c:2: a SOLUTION block inside");
}

static void test_edit(void **unused) {
    (void)unused;
    char *text = task_blocks_edit("abcabd", &(Edit){"file.c", "abd", "X"});
    assert_string_equal(text, "abcX");
    free(text);
    check_clear();
    assert_null(task_blocks_edit("abcabd", &(Edit){"file.c", "ab", "X"}));
    assert_non_null(strstr(check_message(), "more than once"));
    check_clear();
    assert_null(task_blocks_edit("abcabd", &(Edit){"file.c", "zz", "X"}));
    assert_non_null(strstr(check_message(), "nowhere"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_select), cmocka_unit_test(test_lines_stay_true),
                                       cmocka_unit_test(test_refused), cmocka_unit_test(test_edit)};
    return cmocka_run_group_tests_name("source", tests, NULL, NULL);
}
