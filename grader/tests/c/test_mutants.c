// The small changes of a solution: where they are made, which ones, and which equal.json names.
#include "proof/equal.h"
#include "proof/mutations.h"

#include "base/files.h"
#include "compile/task_blocks.h"
#include "scene/check.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char C_TEXT[] = "static float wide, high;\n"
                             "#ifdef SOLUTION // 3.10\n"
                             "    float b = 0.5f * sinf(wide, b); // 7\n"
                             "    if (b < 2 && !high)\n"
                             "        glDrawBuffer(GL_NONE); /* 8 */\n"
                             "    puts(\"1 < 2\");\n"
                             "#else\n"
                             "    // TODO(3.10): 9\n"
                             "    return 9 < 1;\n"
                             "#endif\n"
                             "    high = 9 + 9;\n";

static const char GLSL_TEXT[] = "#version 410 core\n"
                                "#ifdef SOLUTION // 3.5\n"
                                "vec3 p = q.xyz / q.w * 0.5 + 0.5;\n"
                                "for (int i = 0; i < 4; i++)\n"
                                "    o_color = vec4(1.0, 1.0, p.x - 1.0, -1.0);\n"
                                "#endif\n";

static Mutants list(const char *name, const char *text) {
    Mutants mutants = {0};
    Source source;
    source_read(&source, name, text);
    mutations_list(&mutants, &source);
    source_destroy(&source);
    return mutants;
}

static const Mutant *find(const Mutants *mutants, int line, const char *before, const char *replacement) {
    for (int i = 0; i < mutants->count; i++) {
        const Mutant *mutant = &mutants->list[i];
        if (mutant->line == line && strcmp(mutant->before, before) == 0 &&
            strcmp(mutant->replacement, replacement) == 0)
            return mutant;
    }
    return NULL;
}

static void expect_all(const Mutants *mutants, int line, const char *before,
                       const char *const *replacements) {
    for (; *replacements; replacements++) {
        print_message("%d: %s -> %s\n", line, before, *replacements);
        assert_non_null(find(mutants, line, before, *replacements));
    }
}
#define EXPECT(mutants, line, before, ...)                                                                   \
    expect_all(mutants, line, before, (const char *const[]){__VA_ARGS__, NULL})

static void test_kinds_in_c(void **unused) {
    (void)unused;
    Mutants mutants = list("lab.c", C_TEXT);
    EXPECT(&mutants, 3, "0.5f", "0.0f", "1.0f", "1.5f", "-0.5f", "0.25f");
    EXPECT(&mutants, 3, "sinf", "cosf");
    EXPECT(&mutants, 3, "wide, b", "b, wide");
    EXPECT(&mutants, 3, "sinf(wide, b)", "(wide)", "(b)");
    EXPECT(&mutants, 3, "wide", "high", "-wide");
    EXPECT(&mutants, 4, "<", "<=", ">", "==");
    EXPECT(&mutants, 4, "2", "0", "1", "3", "4", "-2");
    EXPECT(&mutants, 4, "&&", "||");
    EXPECT(&mutants, 4, "!", "");
    EXPECT(&mutants, 4, "b < 2 && !high", "true", "false", "!(b < 2 && !high)");
    EXPECT(&mutants, 5, "GL_NONE", "GL_COLOR_ATTACHMENT0", "GL_BACK");
    EXPECT(&mutants, 5, "glDrawBuffer(GL_NONE);", ";");
    EXPECT(&mutants, 6, "puts(\"1 < 2\");", ";");
    mutants_destroy(&mutants);
}

static void test_kinds_in_glsl(void **unused) {
    (void)unused;
    Mutants mutants = list("a.frag", GLSL_TEXT);
    EXPECT(&mutants, 3, "xyz", "zyx", "yzw", "xxx");
    EXPECT(&mutants, 3, "w", "x", "y", "z");
    EXPECT(&mutants, 3, "/", "*", "+", "-");
    EXPECT(&mutants, 4, "++", "--");
    EXPECT(&mutants, 4, "<", "<=");
    EXPECT(&mutants, 5, "-", "", "+");
    EXPECT(&mutants, 5, "1.0", "(-1.0)", "-1.0");
    mutants_destroy(&mutants);
}

// Nothing outside of answers, in comments, strings, or what only the skeleton has; nothing twice.
static void test_places(void **unused) {
    (void)unused;
    Mutants mutants = list("lab.c", C_TEXT);
    for (int i = 0; i < mutants.count; i++) {
        const Mutant *mutant = &mutants.list[i];
        assert_true(mutant->line >= 3 && mutant->line <= 6);
        assert_string_equal(mutant->task, "3.10");
        assert_true(mutant->line < 6 || strcmp(mutant->replacement, ";") == 0);
        assert_null(strpbrk(mutant->before, "789"));
        assert_ptr_equal(find(&mutants, mutant->line, mutant->before, mutant->replacement), mutant);
    }
    mutants_destroy(&mutants);
}

static void test_apply(void **unused) {
    (void)unused;
    Mutants mutants = list("lab.c", C_TEXT);
    char *text = mutant_apply(find(&mutants, 4, "<", ">="), C_TEXT);
    char *solved = task_blocks_select("lab.c", text, (Solved){SOLVED_ALL, NULL}, false);
    assert_string_equal(solved, "static float wide, high;\n"
                                "    float b = 0.5f * sinf(wide, b); // 7\n"
                                "    if (b >= 2 && !high)\n"
                                "        glDrawBuffer(GL_NONE); /* 8 */\n"
                                "    puts(\"1 < 2\");\n"
                                "    high = 9 + 9;\n");
    free(text);
    free(solved);
    mutants_destroy(&mutants);
}

static bool load_equal(EqualList *equal, const char *json) {
    char folder[FILES_PATH], path[FILES_PATH];
    assert_true(files_make_temporary(folder));
    files_join(path, folder, "equal.json");
    assert_true(files_write(path, json));
    const Rubric rubric = {.folder = folder, .files = {"a.frag"}, .file_count = 1};
    check_clear();
    bool ok = equal_load(equal, &rubric);
    files_remove(folder);
    return ok;
}

static void test_equal(void **unused) {
    (void)unused;
    EqualList equal;
    Mutants mutants = list("a.frag", GLSL_TEXT);
    assert_true(load_equal(&equal,
                           "[{\"why\": \"opaque\", \"changes\": ["
                           "{\"file\": \"a.frag\", \"line\": \"vec4(\", \"from\": \"1.0\", \"nth\": 4, "
                           "\"to\": [\"0.0\", \"2.0\"]},"
                           "{\"file\": \"a.frag\", \"line\": \"q.xyz\", \"from\": \"xyz\"},"
                           "{\"file\": \"a.frag\", \"line\": \"o_color\", \"from\": \"xyz\"}]}]"));
    int named = 0;
    for (int i = 0; i < mutants.count; i++) {
        const EqualChange *change = equal_find(&equal, "a.frag", GLSL_TEXT, &mutants.list[i]);
        named += change != NULL;
        assert_true(!change || strcmp(change->why, "opaque") == 0);
        assert_null(equal_find(&equal, "b.frag", GLSL_TEXT, &mutants.list[i]));
    }
    assert_int_equal(named, 2 + 3);
    assert_int_equal(equal.changes[0].matched, 2);
    assert_int_equal(equal.changes[1].matched, 3);
    assert_int_equal(equal.changes[2].matched, 0);
    equal_destroy(&equal);
    mutants_destroy(&mutants);
}

static void test_equal_refused(void **unused) {
    (void)unused;
    static const char *const wrong[][2] = {
        {"{}", "expected a list"},
        {"[{\"changes\": [{\"file\": \"a.frag\", \"line\": \"a\", \"from\": \"b\"}]}]",
         "[0]: why: is missing"},
        {"[{\"why\": \"so\", \"changes\": []}]", "[0]: changes: [] does not fit"},
        {"[{\"why\": \"so\", \"changes\": [1], \"because\": 2}]", "there is no key \"because\""},
        {"[{\"why\": \"so\", \"changes\": [{\"file\": \"b.c\", \"line\": \"a\", \"from\": \"b\"}]}]",
         "[0]: changes[0]: file: \"b.c\" is not in the list"},
        {"[{\"why\": \"so\", \"changes\": [{\"file\": \"a.frag\", \"from\": \"b\"}]}]",
         "[0]: changes[0]: line: is missing"},
        {"[{\"why\": \"so\", \"changes\": [{\"file\": \"a.frag\", \"line\": \"a\", \"from\": \"b\", \"to\": "
         "\"c\"}]}]",
         "[0]: changes[0]: to: \"c\" does not fit"},
        {"[", "equal.json:1"}};
    EqualList equal;
    for (size_t i = 0; i < COUNT(wrong); i++) {
        assert_false(load_equal(&equal, wrong[i][0]));
        print_message("%s\n", check_message());
        assert_non_null(strstr(check_message(), wrong[i][1]));
        equal_destroy(&equal);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_kinds_in_c), cmocka_unit_test(test_kinds_in_glsl),
        cmocka_unit_test(test_places),     cmocka_unit_test(test_apply),
        cmocka_unit_test(test_equal),      cmocka_unit_test(test_equal_refused)};
    return cmocka_run_group_tests_name("mutants", tests, NULL, NULL);
}
