// Where a task is still to be done: in the lab's files, under the names that they have in the student's
// folder.
#include "base/files.h"
#include "compile/todo.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static char folder[FILES_PATH];
static const Rubric rubric = {.id = "03", .files = {"lab.c", "shadow.frag"}, .file_count = 2};

static int begin(void **unused) {
    (void)unused;
    return files_make_temporary(folder) ? 0 : 1;
}

static int end(void **unused) {
    (void)unused;
    files_remove(folder);
    return 0;
}

static void put(const char *name, const char *text) {
    char path[FILES_PATH];
    files_join(path, folder, name);
    assert_true(files_write(path, text));
}

static void expect(const char *task, const char *wanted) {
    char place[300] = "";
    assert_int_equal(todo_find(&rubric, folder, task, place, sizeof place), wanted != NULL);
    if (wanted)
        assert_string_equal(place, wanted);
}

static void test_as_handed_out(void **unused) {
    (void)unused;
    put("lab.c", "int a;\n// TODO(3.1): x\n// TODO(3.10): y\n");
    put("shadow.frag", "// TODO(3.5)\n");
    expect("3.1", "lab.c:2");
    expect("3.10", "lab.c:3");
    expect("3.5", "shadow.frag:1");
    expect("3.2", NULL);
}

static void test_renamed(void **unused) {
    (void)unused;
    static const char *const names[] = {"lab (1).c", "lab-1.c", "Lab.C", "lab.c.txt", "Copy of lab.c"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        char wanted[300], path[FILES_PATH];
        put(names[i], "\n\n// TODO(3.1)\n");
        snprintf(wanted, sizeof wanted, "%s:3", names[i]);
        expect("3.1", wanted);
        expect("3.5", NULL);
        files_join(path, folder, names[i]);
        assert_int_equal(remove(path), 0);
    }
    put("lab (1).c", "// TODO(3.1)\n"); // an old copy beside the lab is not read
    put("lab.c", "int a;\n");
    expect("3.1", NULL);
}

static void test_nothing(void **unused) {
    (void)unused;
    expect("3.1", NULL);
    put("other.c", "// TODO(3.1)\n");
    expect("3.1", NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_as_handed_out, begin, end),
        cmocka_unit_test_setup_teardown(test_renamed, begin, end),
        cmocka_unit_test_setup_teardown(test_nothing, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
