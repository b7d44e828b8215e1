// What is told when a lab is done: all labs have it, and what is wrong in it is refused with its place.
#include "compile/afterword.h"
#include "base/places.h"
#include "scene/check.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#define IDEA "\"idea\": \"i\""
#define ONE(about) "{\"about\": \"" about "\", \"answer\": [\"a\", \"b\"]}"
#define ASKED(first) "\"questions\": [" first ", " ONE("v") ", " ONE("w") "]"
#define ANSWER ASKED(ONE("u"))
#define WAY "\"another way\": \"w\""
#define TRY "\"try\": [\"t\"]"

static char folder[FILES_PATH];

static bool load(Afterword *afterword, const char *text) {
    char path[FILES_PATH];
    const Rubric rubric = {.folder = folder};
    files_join(path, folder, "afterword.json");
    check_clear();
    assert_true(files_write(path, text));
    return afterword_load(afterword, &rubric);
}

static void test_good(void **unused) {
    (void)unused;
    Afterword afterword;
    assert_true(load(&afterword, "{" IDEA ", " ANSWER ", " WAY ", " TRY "}"));
    assert_string_equal(afterword.idea, "i");
    for (int q = 0; q < AFTERWORD_QUESTIONS; q++) {
        assert_int_equal(afterword.answers[q].part_count, 2);
        assert_string_equal(afterword.answers[q].parts[1], "b");
    }
    assert_string_equal(afterword.answers[0].about, "u");
    assert_string_equal(afterword.answers[2].about, "w");
    assert_string_equal(afterword.other_way, "w");
    assert_int_equal(afterword.try_count, 1);
    afterword_destroy(&afterword);
    assert_null(afterword.idea);
}

static void test_none(void **unused) {
    (void)unused;
    Afterword afterword;
    const Rubric rubric = {.folder = "/no/such/folder"};
    assert_true(afterword_load(&afterword, &rubric));
    assert_null(afterword.idea);
    afterword_destroy(&afterword);
}

static void test_wrong(void **unused) {
    (void)unused;
    static const char *const wrong[][2] = {
        {"{", "afterword.json:1: "},
        {"[]", "expected an object { }"},
        {"{" IDEA ", " ANSWER ", " WAY "}", "try: is missing; write a list"},
        {"{" IDEA ", " ANSWER ", " WAY ", " TRY ", \"tries\": []}", "there is no key \"tries\""},
        {"{" IDEA ", \"answer\": [\"a\"], " WAY ", " TRY "}", "there is no key \"answer\""},
        {"{" IDEA ", \"questions\": [" ONE("u") ", " ONE("v") "], " WAY ", " TRY "}",
         "write a list [ ] of 3 to 3 entries"},
        {"{" IDEA ", \"questions\": [" ONE("t") ", " ONE("u") ", " ONE("v") ", " ONE("w") "], " WAY ", " TRY
                                                                                          "}",
         "write a list [ ] of 3 to 3 entries"},
        {"{" IDEA ", " ASKED("\"a\"") ", " WAY ", " TRY "}",
         "questions[0]: \"a\" does not fit; write an object"},
        {"{" IDEA ", " ASKED("{\"about\": \"u\"}") ", " WAY ", " TRY "}", "questions[0]: answer: is missing"},
        {"{" IDEA ", " ASKED(ONE("")) ", " WAY ", " TRY "}", "questions[0]: about: \"\" does not fit"},
        {"{" IDEA ", " ASKED("{\"about\": \"u\", \"answer\": []}") ", " WAY ", " TRY "}",
         "answer: [] does not fit"},
        {"{" IDEA ", " ASKED("{\"about\": \"u\", \"answer\": [\"a\", 3]}") ", " WAY ", " TRY "}",
         "questions[0]: answer[1]: 3 does not fit; write a text"},
        {"{" IDEA ", " ANSWER ", " WAY ", \"try\": [\"1\", \"2\", \"3\", \"4\", \"5\", \"6\", \"7\"]}",
         "try: "},
    };
    for (size_t i = 0; i < COUNT(wrong); i++) {
        Afterword afterword;
        assert_false(load(&afterword, wrong[i][0]));
        if (!strstr(check_message(), wrong[i][1]))
            fail_msg("%s: no \"%s\" in \"%s\"", wrong[i][0], wrong[i][1], check_message());
        assert_null(afterword.idea);
    }
}

static void look(const char *id, void *context) {
    char path[FILES_PATH];
    Afterword afterword;
    int *labs = context;
    assert_true(places_find_lab(path, id));
    const Rubric rubric = {.folder = path};
    if (!afterword_load(&afterword, &rubric))
        fail_msg("%s", check_message());
    if (!afterword.idea)
        fail_msg("lab %s has no afterword", id);
    afterword_destroy(&afterword);
    ++*labs;
}

static void test_all_labs(void **unused) {
    (void)unused;
    int labs = 0;
    assert_true(places_list_labs(look, &labs));
    assert_true(labs > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_good), cmocka_unit_test(test_none),
                                       cmocka_unit_test(test_wrong), cmocka_unit_test(test_all_labs)};
    check_clear();
    if (!files_make_temporary(folder))
        return 1;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    files_remove(folder);
    return failed;
}
