// What a lecturer writes: each fault ends in one message with file, entry and remedy.
#include "compile/rubric_file.h"
#include "scene/check.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define CHECK                                                                                                \
    "\"name\": \"c\", \"task\": \"3.1\", \"points\": 5, \"view\": \"picture\", \"scene\": \"table spot\""
#define HEAD "\"title\": \"t\", \"pass_mark\": 95, \"files\": [\"lab.c\"]"
#define RUBRIC "{" HEAD ", \"checks\": [{" CHECK ", \"variants\": 3}]}"
#define MISTAKE "{\"name\": \"m\", \"task\": \"3.1\", \"hint\": \"h\"}"
#define EDIT "{\"file\": \"lab.c\", \"find\": [\"x\", \"y\"], \"replace\": \"z\"}"

static const char *const good[RUBRIC_FILES] = {RUBRIC, "[" MISTAKE "]",
                                               "[{\"name\": \"a\", \"edits\": [" EDIT "]}]",
                                               "{\"3.1\": [\"first\", [\"second\", \"line\"]]}"};
static const char *const names[RUBRIC_FILES] = {"rubric.json", "mistakes.json", "alternatives.json",
                                                "hints.json"};

static bool read_with(Rubric *rubric, int file, const char *text) {
    const char *texts[RUBRIC_FILES];
    memcpy(texts, good, sizeof texts);
    texts[file] = text;
    check_clear();
    return rubric_read(rubric, "solutions/03-test", texts);
}

static void test_good(void **unused) {
    Rubric rubric;
    (void)unused;
    if (!read_with(&rubric, RUBRIC_JSON, RUBRIC))
        fail_msg("%s", check_message());
    assert_string_equal(rubric.id, "03");
    assert_int_equal(rubric_points(&rubric), 5);
    assert_string_equal(rubric.alternatives[0].edits[0].find, "x\ny");
    assert_string_equal(rubric_hint(&rubric, "3.1", 1), "second\nline");
    assert_null(rubric_hint(&rubric, "3.1", 2));
    rubric_destroy(&rubric);
}

typedef struct Refusal {
    int file;
    const char *text, *message;
} Refusal;

// A rubric whose only check has `end` behind the keys of CHECK, or with something else in the place of HEAD.
#define ONE(end) "{" HEAD ", \"checks\": [{" CHECK ", " end "}]}"
#define WITH(head) "{" head ", \"checks\": [{" CHECK ", \"variants\": 3}]}"
#define FILES(list) WITH("\"title\": \"t\", \"pass_mark\": 95, \"files\": " list)
#define AT "checks[0] \"c\": "
#define TEN(x) x x x x x x x x x x
#define HUNDRED(x) TEN(x) TEN(x) TEN(x) TEN(x) TEN(x) TEN(x) TEN(x) TEN(x) TEN(x) TEN(x)

static const Refusal refusals[] = {
    {RUBRIC_JSON, "{", "rubric.json:1: "},
    {RUBRIC_JSON, "", "rubric.json:1: "},
    {RUBRIC_JSON, "[]", "rubric.json:1: expected an object { }"},
    {RUBRIC_JSON, "{\"title\": \"a\", \"title\": \"b\"}", "rubric.json:1: duplicate object key"},
    {RUBRIC_JSON, "{\"title\": \"\xff\"}", "rubric.json:1: "},
    {RUBRIC_JSON, "{\"title\": 1e999}", "rubric.json:1: "},
    {RUBRIC_JSON, ONE("\"variants\": 60"), AT "variants: 60 does not fit; write a whole number from 1 to 8"},
    {RUBRIC_JSON, ONE("\"variants\": 9"), AT "variants: 9 does not fit"},
    {RUBRIC_JSON, ONE("\"variants\": 0"), AT "variants: 0 does not fit"},
    {RUBRIC_JSON, ONE("\"variants\": 99999999999"), AT "variants: 99999999999 does not fit"},
    {RUBRIC_JSON, ONE("\"variants\": 2.5"), AT "variants: 2.5 does not fit; write a whole number"},
    {RUBRIC_JSON, ONE("\"variants\": \"3\""), AT "variants: \"3\" does not fit"},
    {RUBRIC_JSON, ONE("\"varients\": 3"),
     AT "there is no key \"varients\"; the keys here are \"name\", \"task\""},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [{" CHECK "}]}", AT "variants: is missing; write a whole number"},
    {RUBRIC_JSON, ONE("\"variants\": 3, \"optional\": 1"),
     AT "optional: 1 does not fit; write true or false"},
    {RUBRIC_JSON, ONE("\"variants\": 3, \"knobs\": []"), AT "knobs: [] does not fit; write an object { }"},
    {RUBRIC_JSON, ONE("\"variants\": 3, \"knobs\": {\"bias\": \"big\"}"),
     AT "bias: \"big\" does not fit; write a number"},
    {RUBRIC_JSON, ONE("\"variants\": 3, \"knobs\": {\"bias\": 1e300}"), AT "bias: 1e300 does not fit"},
    {RUBRIC_JSON, ONE("\"variants\": 3, \"knobs\": {\"" TEN("bias") "\": 1}"),
     AT "knobs: a name is longer than 31 bytes"},
    {RUBRIC_JSON,
     ONE("\"variants\": 3, \"knobs\": "
         "{\"a\":1,\"b\":1,\"c\":1,\"d\":1,\"e\":1,\"f\":1,\"g\":1,\"h\":1,\"i\":1,\"j\":1,"
         "\"k\":1,\"l\":1,\"m\":1}"),
     "write an object { } of 0 to 12 keys"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": []}",
     "rubric.json: checks: [] does not fit; write a list [ ] of 1 to 16 entries"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}",
     "write a list [ ] of 1 to 16 entries"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [7]}", "checks[0]: 7 does not fit; write an object { }"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [{" CHECK ", \"variants\": 3}, {" CHECK ", \"variants\": 3}]}",
     "checks[1] \"c\": name: checks[0] has this name, too"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [{\"name\": \"\"}]}",
     "checks[0]: name: \"\" does not fit; write a text of one line"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [{\"name\": \"a\\u001b[2J\"}]}",
     "checks[0]: name: \"a\\u001B[2J\" does not fit"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [{\"name\": \"" HUNDRED("n") "\"}]}", "checks[0]: name: \"nnn"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [{\"points\": -5}]}",
     "checks[0]: points: -5 does not fit; write a whole number from 1"},
    {RUBRIC_JSON, "{" HEAD ", \"checks\": [{\"view\": \"" TEN("view") "\"}]}", "view: \"viewview"},
    {RUBRIC_JSON,
     "{" HEAD ", \"checks\": [{\"name\": \"c\", \"task\": \"4.1\", \"points\": 5, \"view\": \"v\", "
     "\"scene\": \"table spot\", \"variants\": 3}]}",
     AT "task: \"4.1\" is no task of lab 03; write \"3.1\" to \"3.31\""},
    {RUBRIC_JSON,
     "{" HEAD ", \"checks\": [{\"name\": \"c\", \"task\": \"3.32\", \"points\": 5, \"view\": \"v\", "
     "\"scene\": \"table spot\", \"variants\": 3}]}",
     AT "task: \"3.32\" is no task"},
    {RUBRIC_JSON,
     "{" HEAD ", \"checks\": [{\"name\": \"c\", \"task\": \"3.1\", \"points\": 5, \"view\": \"v\", "
     "\"scene\": \"moon\", \"variants\": 3}]}",
     AT "scene: there is no scene \"moon\"; the scenes are \""},
    {RUBRIC_JSON, WITH("\"title\": \"t\", \"files\": [\"lab.c\"]"), "rubric.json: pass_mark: is missing"},
    {RUBRIC_JSON, WITH("\"title\": \"t\", \"pass_mark\": 101, \"files\": [\"lab.c\"]"),
     "pass_mark: 101 does not fit; write a number from 0 to 100"},
    {RUBRIC_JSON, WITH("\"title\": \"t\", \"pass_mark\": -1, \"files\": [\"lab.c\"]"),
     "pass_mark: -1 does not fit"},
    {RUBRIC_JSON, WITH("\"title\": \"\", \"pass_mark\": 95, \"files\": [\"lab.c\"]"),
     "title: \"\" does not fit"},
    {RUBRIC_JSON, FILES("[\"lab.c\", \"a/b.c\"]"),
     "files[1]: \"a/b.c\" is no plain name of a C or GLSL file"},
    {RUBRIC_JSON, FILES("[\"lab.c\", \"../b.c\"]"), "files[1]: \"../b.c\" is no plain name"},
    {RUBRIC_JSON, FILES("[\"lab.c\", \"..\"]"), "files[1]: \"..\" is no plain name"},
    {RUBRIC_JSON, FILES("[\"lab.c\", \"-o.c\"]"), "files[1]: \"-o.c\" is no plain name"},
    {RUBRIC_JSON, FILES("[\"lab.c\", \"lab.so\"]"), "files[1]: \"lab.so\" is no plain name"},
    {RUBRIC_JSON, FILES("[\"lab.c\", \"lab.c\"]"), "files[1]: \"lab.c\" is in the list twice"},
    {RUBRIC_JSON, FILES("[\"lab.c\", 3]"), "files[1]: 3 does not fit; write a text"},
    {RUBRIC_JSON, FILES("[\"shadow.frag\"]"), "files: \"lab.c\" is missing; add it"},
    {RUBRIC_JSON, FILES("[1,2,3,4,5,6,7,8,9]"),
     "files: [1,2,3,4,5,6,7,8,9] does not fit; write a list [ ] of 1 to 8 entries"},
    {MISTAKES_JSON, "{}", "mistakes.json:1: expected a list [ ]"},
    {MISTAKES_JSON, "[3]", "mistakes.json: [0]: 3 does not fit; write an object { }"},
    {MISTAKES_JSON, "[{\"name\": \"m\"}]", "mistakes.json: [0] \"m\": task: is missing"},
    {MISTAKES_JSON, "[" MISTAKE ", " MISTAKE "]", "mistakes.json: [1] \"m\": name: [0] has this name, too"},
    {MISTAKES_JSON, "[{\"name\": \"m\", \"task\": \"3.2\", \"hint\": \"h\"}]",
     "[0] \"m\": task: no check of rubric.json is about task \"3.2\""},
    {MISTAKES_JSON, "[{\"name\": \"m\", \"task\": \"3.1\", \"hint\": [\"h\", 2]}]",
     "[0] \"m\": hint: [\"h\",2] does not fit; write a text, or a list of lines"},
    {MISTAKES_JSON,
     "[{\"name\": \"m\", \"task\": \"3.1\", \"hint\": \"h\", \"edits\": [{\"file\": \"lab.h\", \"find\": "
     "\"a\", \"replace\": \"b\"}]}]",
     "[0] \"m\": edits[0]: file: \"lab.h\" is not in the list \"files\""},
    {MISTAKES_JSON,
     "[{\"name\": \"m\", \"task\": \"3.1\", \"hint\": \"h\", \"edits\": [" EDIT "," EDIT "," EDIT "," EDIT
     "," EDIT "," EDIT "," EDIT "]}]",
     "write a list [ ] of 1 to 6 entries"},
    {MISTAKES_JSON, "[" HUNDRED("0,") "0]", "mistakes.json: [0,0,0"},
    {ALTERNATIVES_JSON, "[{\"name\": \"a\", \"edits\": []}]",
     "alternatives.json: [0] \"a\": edits: [] does not fit"},
    {ALTERNATIVES_JSON,
     "[{\"name\": \"a\", \"edits\": [{\"file\": \"lab.c\", \"find\": \"\", \"replace\": \"b\"}]}]",
     "edits[0]: find: \"\" does not fit"},
    {ALTERNATIVES_JSON, "[{\"name\": \"a\", \"edits\": [{\"file\": \"lab.c\", \"find\": \"a\"}]}]",
     "edits[0]: replace: is missing"},
    {ALTERNATIVES_JSON, "[{\"name\": \"a\", \"edit\": []}]",
     "[0] \"a\": there is no key \"edit\"; the keys here are \"name\", \"edits\""},
    {HINTS_JSON, "{\"3.44\": [\"h\"]}", "hints.json: task: \"3.44\" is no task of lab 03"},
    {HINTS_JSON, "{\"3.2\": [\"h\"]}", "hints.json: task: no check of rubric.json is about task \"3.2\""},
    {HINTS_JSON, "{\"3.1\": \"h\"}", "hints.json: 3.1: \"h\" does not fit; write a list [ ]"},
    {HINTS_JSON, "{\"3.1\": []}", "hints.json: 3.1: [] does not fit"},
    {HINTS_JSON, "{\"3.1\": [5]}", "hints.json: \"3.1\"[0]: 5 does not fit; write a text"},
    {HINTS_JSON, "{\"3.1\\u001b[2J\": [\"h\"]}", "\"3.1?[2J\" is no task"},
};

static void test_refusals(void **unused) {
    Rubric rubric;
    (void)unused;
    for (unsigned i = 0; i < COUNT(refusals); i++) {
        const Refusal *refusal = &refusals[i];
        if (read_with(&rubric, refusal->file, refusal->text))
            fail_msg("taken: %s", refusal->text);
        if (getenv("SHADOW_LAB_SHOW"))
            printf("%s\n    %s\n", refusal->text, check_message());
        if (!strstr(check_message(), refusal->message) || !strstr(check_message(), names[refusal->file]))
            fail_msg("%s\n  no \"%s\" in: %s", refusal->text, refusal->message, check_message());
    }
}

static void test_folder_name(void **unused) {
    Rubric rubric;
    (void)unused;
    check_clear();
    assert_false(rubric_read(&rubric, "solutions/moon", good));
    assert_non_null(strstr(check_message(), "the folder of a lab is named NN-name"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_good), cmocka_unit_test(test_refusals),
                                       cmocka_unit_test(test_folder_name)};
    return cmocka_run_group_tests_name("lecturer's files", tests, NULL, NULL);
}
