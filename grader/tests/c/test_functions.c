// The splitter: where functions of C and GLSL begin and end however they are written, and what comes out when
// parts of one version of a file are put into another.
#include "compile/functions.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static Functions theirs, ours;

// Splits; the names found, in order, must be `names`, each followed by a blank.
static void expect_names(const char *text, const char *names) {
    char found[400] = "";
    functions_split(&theirs, text);
    assert_false(theirs.whole);
    for (int i = 0; i < theirs.count; i++) {
        strcat(found, theirs.list[i].name);
        strcat(found, " ");
        assert_int_equal(text[theirs.list[i].end - 1], '}');
    }
    assert_string_equal(found, names);
}

static void test_layouts(void **unused) {
    (void)unused;
    expect_names("int f(void) { return 1; }\nint g(void)\n{\n    if (f()) {\n    }\n    return 2;\n}\n",
                 "f g ");
    expect_names("static inline float\nshadow(vec3 a,\n       vec3 b) // a comment {\n{ return 0.0; }",
                 "shadow ");
    expect_names("__attribute__((noinline)) int f(void) __attribute__((x));\n"
                 "__attribute__((noinline)) int f(void) { return 1; }",
                 "f ");
    expect_names("subroutine(ShadeType, Other)\nvec3 shade(vec3 a) { return a; }", "shade ");
    expect_names("int *f(int (*g)(int), int k[2]) { return 0; }", "f ");
}

static void test_what_is_no_function(void **unused) {
    (void)unused;
    expect_names("struct S { int a; } s;\nenum { A = sizeof(int) };\nint k[] = {1, 2};\nint f(int a);\n", "");
    expect_names("layout(std140) uniform Block { vec4 a; } u_block;\nlayout(triangles) in;\n", "");
    expect_names("const Lab lab = {.create = create, .knobs = {{(1), 2}}};\nint f(void) {}", "f ");
    expect_names("static const vec2 k[2] = vec2[2](vec2(0), vec2(1));\nvoid main() {}", "main ");
}

static void test_quotes_and_comments(void **unused) {
    (void)unused;
    expect_names("int f(void) { return '{' + \"}}\\\"{\"[0]; /* } */ // }\n }\nint g(void) {}", "f g ");
    expect_names("/* int f(void) { */ int g(void) { return '\\''; }", "g ");
    expect_names("int f(void) { return 1; } // isn't\nint g(void) {}", "f g ");
}

static void test_directives(void **unused) {
    (void)unused;
    expect_names("#define BEGIN(x) { \\\n    x\n#define END }\nint f(void) { return 1; }", "f ");
    expect_names("#define BLOCK do { int a; /* over\n two lines { */ } while (0)\nvoid f(void) { BLOCK; }",
                 "f ");
    expect_names("#if 0\nint f(void) { isn't {\n#endif\nint g(void) {}\n", "g ");
    expect_names("#if A\nint f(void) { return 1; }\n#else\nint f(void) { return 2; }\n#endif\nint g(void) {}",
                 "f f g ");
    expect_names("int f(void) {\n#if A\n    if (a) {\n#else\n    if (b) {\n#endif\n    }\n}\nint g(void) {}",
                 "f g ");
}

static void expect_whole(const char *text) {
    functions_split(&theirs, text);
    assert_true(theirs.whole);
    assert_int_equal(theirs.count, 0);
}

static void test_what_cannot_be_split(void **unused) {
    (void)unused;
    expect_whole("int f(void) { if (1) { }");
    expect_whole("int f(void) { } }");
    expect_whole("#if A\nint f(void) {\n#else\nint g(void) {\n#endif\n}");
    expect_whole("#if A\nint f(void) {}\n");
}

static void compare(const char *a, const char *b, bool same, bool same_outside) {
    functions_split(&theirs, a);
    functions_split(&ours, b);
    assert_int_equal(functions_same(&theirs, &ours, "f"), same);
    assert_int_equal(functions_same_outside(&theirs, &ours), same_outside);
}

static void test_same(void **unused) {
    (void)unused;
    compare("int f(void) { return 1; }", "// why\nint f(void)\n{\n    return /* one */ 1;\n}", true, true);
    compare("int f(void) { return 1; }", "int f(void) { return 2; }", false, true);
    compare("int a;\nint f(void) { return 1; }", "int b;\nint f(void) { return 1; }", true, false);
    compare("int f(void) { return ab; }", "int f(void) { return a b; }", false, true);
    compare("#define A 1\nint f(void) {}", "#define A  1 // one\nint f(void) {}", true, true);
    compare("#define A 1\nint f(void) {}", "#define A 2\nint f(void) {}", true, false);
}

static void test_signature(void **unused) {
    (void)unused;
    functions_split(&theirs, "float lit(vec3 p, float b) { return b; }\nvec3 tone(vec3 c) { return c; }");
    functions_split(&ours, "float visibility(vec3 position, float bias) { return bias; }");
    assert_true(functions_same_signature(&theirs, "lit", &ours, "visibility"));
    assert_false(functions_same_signature(&theirs, "tone", &ours, "visibility"));
}

static void compose(const char *a, const char *b, Choice choice, const char *expected) {
    functions_split(&theirs, a);
    functions_split(&ours, b);
    char *text = functions_compose(&theirs, &ours, &choice);
    assert_non_null(text);
    Functions left, right;
    functions_split(&left, text);
    functions_split(&right, expected);
    if (strspn(text, " \n") == strlen(text) || left.count != right.count ||
        !functions_same_outside(&left, &right))
        fail_msg("%s\ninstead of\n%s", text, expected);
    for (int i = 0; i < right.count; i++) {
        assert_string_equal(left.list[i].name, right.list[i].name);
        assert_true(functions_same(&left, &right, right.list[i].name));
    }
    free(text);
}

static void test_swap_one(void **unused) {
    (void)unused;
    compose("int a;\nint f(void) { return 0; }\nint g(void) { return 0; }\n",
            "int b;\nint f(void) { return 1; }\nint g(void) { return 1; }\n",
            (Choice){{"g"}, {NULL}, 1, false},
            "int a;\nint f(void) { return 0; }\nint g(void) { return 1; }\n");
}

static void test_swap_brings_what_it_calls(void **unused) {
    (void)unused;
    compose("int f(void) { return 0; }\n",
            "int k(void) { return 3; }\nint h(void) { return k(); }\nint f(void) { return h(); }\n",
            (Choice){{"f"}, {NULL}, 1, false},
            "int k(void) { return 3; }\nint h(void) { return k(); }\nint f(void) { return h(); }\n");
}

static void test_swap_of_overloads_and_branches(void **unused) {
    (void)unused;
    compose("int f(int a) { return 0; }\nint f(float a) { return 0; }\n", "int f(int a) { return 1; }\n",
            (Choice){{"f"}, {NULL}, 1, false}, "int f(int a) { return 1; }\n");
    compose("#if A\nint f(void) { return 0; }\n#else\nint f(void) { return 2; }\n#endif\n",
            "int f(void) { return 1; }\n", (Choice){{"f"}, {NULL}, 1, false},
            "#if A\nint f(void) { return 1; }\n#else\nint f(void) { return 1; }\n#endif\n");
}

static void test_swap_under_another_name(void **unused) {
    (void)unused;
    compose("int mine(int a) { return 0; }\nint g(void) { return mine(1); }\n",
            "int f(int a) { return a ? f(0) : 1; }\nint g(void) { return f(1); }\n",
            (Choice){{"f"}, {"mine"}, 1, false},
            "int mine(int a) { return a ? mine(0) : 1; }\nint g(void) { return mine(1); }\n");
}

static void test_swap_outside(void **unused) {
    (void)unused;
    compose("int a;\nint help(void) { return 0; }\nint f(void) { return help(); }\nint g(void) { return 0; "
            "}\nint t;",
            "int b;\nint f(void) { return 1; }\nint g(void) { return 1; }\nint u;\n",
            (Choice){{"g"}, {NULL}, 1, true},
            "int b;\nint help(void) { return 0; }\nint f(void) { return help(); }\nint g(void) { return 1; "
            "}\nint u;");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_layouts),
                                       cmocka_unit_test(test_what_is_no_function),
                                       cmocka_unit_test(test_quotes_and_comments),
                                       cmocka_unit_test(test_directives),
                                       cmocka_unit_test(test_what_cannot_be_split),
                                       cmocka_unit_test(test_same),
                                       cmocka_unit_test(test_signature),
                                       cmocka_unit_test(test_swap_one),
                                       cmocka_unit_test(test_swap_brings_what_it_calls),
                                       cmocka_unit_test(test_swap_of_overloads_and_branches),
                                       cmocka_unit_test(test_swap_under_another_name),
                                       cmocka_unit_test(test_swap_outside)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
