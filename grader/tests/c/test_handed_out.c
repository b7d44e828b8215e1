// The parts of a lab as it was handed out: which tasks lie in them, and a file with one of them reset.
#include "compile/parts.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char handed[] = "uniform float u_bias;\n"
                             "float lookup() {\n    // TODO(3.1): ask the map\n    return 1.0;\n}\n"
                             "void main() {\n    o_color = lookup(); // TODO(3.2), second part\n}\n";
static const char theirs[] = "uniform float u_bias;\nuniform float u_other;\n"
                             "float lookup() {\n    return texture(map).r + u_other;\n}\n"
                             "void main() {\n    o_color = lookup();\n}\n";

static Rubric rubric = {.files = {"a.frag"}, .file_count = 1};
static Parts parts;
static Functions version;

static void list(const char *text) {
    char *texts[1] = {strdup(text)};
    parts_list(&parts, &rubric, texts);
}

static int find(const char *function) {
    for (int p = 0; p < parts.count; p++)
        if (strcmp(parts.list[p].function, function) == 0)
            return p;
    fail_msg("no part %s", function);
    return -1;
}

static void test_tasks(void **unused) {
    (void)unused;
    list(handed);
    assert_int_equal(parts.count, 3); // two functions and the rest
    assert_true(parts_have_task(&parts, find("lookup"), "3.1"));
    assert_false(parts_have_task(&parts, find("lookup"), "3.2"));
    assert_true(parts_have_task(&parts, find("main"), "3.2"));
    assert_false(parts_have_task(&parts, find(""), "3.1"));
    parts_destroy(&parts);
}

// Comments are no change; a body, and a line outside of functions, are.
static void test_same(void **unused) {
    (void)unused;
    list(handed);
    functions_split(&version, theirs);
    assert_false(parts_same(&parts, find("lookup"), &version));
    assert_true(parts_same(&parts, find("main"), &version));
    assert_false(parts_same(&parts, find(""), &version));
    parts_destroy(&parts);
}

static void expect_reset(int p, int q, const char *there, const char *gone) {
    char *text = parts_reset(&parts, 0, &version, p, q);
    assert_non_null(strstr(text, there));
    assert_null(strstr(text, gone));
    free(text);
}

static void test_reset(void **unused) {
    (void)unused;
    list(handed);
    functions_split(&version, theirs);
    expect_reset(find("lookup"), -1, "return 1.0;", "texture(map)");
    expect_reset(find("lookup"), -1, "u_other;", "return texture");
    expect_reset(find(""), -1, "return texture(map)", "uniform float u_other;");
    expect_reset(find("lookup"), find(""), "return 1.0;", "u_other");
    parts_destroy(&parts);
}

// Functions that are to be written are in no part: then the file is one.
static void test_tasks_outside(void **unused) {
    (void)unused;
    list("// TODO(1.3): a function shade\nvoid main() {\n    // TODO(1.1)\n}\n");
    functions_split(&version, theirs);
    const int whole = find("");
    assert_true(parts.list[whole].whole);
    assert_true(parts_have_task(&parts, whole, "1.3"));
    assert_false(parts_have_task(&parts, find("main"), "1.3"));
    expect_reset(whole, -1, "a function shade", "lookup");
    parts_destroy(&parts);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_tasks), cmocka_unit_test(test_same),
                                       cmocka_unit_test(test_reset), cmocka_unit_test(test_tasks_outside)};
    return cmocka_run_group_tests_name("parts as handed out", tests, NULL, NULL);
}
