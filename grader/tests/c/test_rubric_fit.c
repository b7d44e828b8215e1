// A rubric against its lab: views, knobs and their ranges, tasks and edits.
#include "base/files.h"
#include "compile/rubric_file.h"
#include "compile/rubric_fit.h"
#include "scene/check.h"

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

static bool read_with(Rubric *rubric, int file, const char *text) {
    const char *texts[RUBRIC_FILES];
    memcpy(texts, good, sizeof texts);
    texts[file] = text;
    check_clear();
    return rubric_read(rubric, "solutions/03-test", texts);
}

#define ONE(end) "{" HEAD ", \"checks\": [{" CHECK ", " end "}]}"

static const Description described = {.knobs = {{.name = "map size", .low = 16, .high = 4096}},
                                      .stages = {"shadow map"},
                                      .knob_count = 1,
                                      .stage_count = 1};

static void assert_fit(const char *rubric_text, const char *message) {
    Rubric rubric;
    if (!read_with(&rubric, RUBRIC_JSON, rubric_text))
        fail_msg("%s", check_message());
    const bool fits = rubric_fit_lab(&rubric, &described);
    if (fits != (message == NULL) || (message && !strstr(check_message(), message)))
        fail_msg("%s: %s", rubric_text, check_message());
    rubric_destroy(&rubric);
}

#define VIEW(view)                                                                                           \
    "{" HEAD ", \"checks\": [{\"name\": \"c\", \"task\": \"3.1\", \"points\": 5, \"view\": \"" view          \
    "\", \"scene\": \"table spot\", \"variants\": 3}]}"

static void test_fits_the_lab(void **unused) {
    (void)unused;
    assert_fit(VIEW("shadow map"), NULL);
    assert_fit(VIEW("visibility"), NULL);
    assert_fit(VIEW("moon"),
               "rubric.json: checks[0] \"c\": view: the lab has no stage \"moon\"; write one of \"picture\", "
               "\"visibility\", \"shadow map\"");
    assert_fit(ONE("\"variants\": 3, \"knobs\": {\"map size\": 4096}"), NULL);
    assert_fit(ONE("\"variants\": 3, \"knobs\": {\"map size\": 4097}"),
               "checks[0] \"c\": knobs: \"map size\": 4097 is outside of the knob's range; write a number "
               "from 16 to 4096");
    assert_fit(ONE("\"variants\": 3, \"knobs\": {\"map\": 5}"),
               "knobs: the lab has no knob \"map\"; its knobs are \"map size\"");
}

static void assert_refused(const char *rubric_text, const char *message) {
    Rubric rubric;
    const bool read = read_with(&rubric, RUBRIC_JSON, rubric_text);
    rubric_destroy(&rubric);
    if (read || !strstr(check_message(), message))
        fail_msg("%s: %s", rubric_text, read ? "taken" : check_message());
}

#define SIZE(value) ONE("\"variants\": 3, \"knobs\": {\"map size\": " value "}")
#define SCENE(scene)                                                                                         \
    "{" HEAD ", \"checks\": [{\"name\": \"c\", \"task\": \"3.1\", \"points\": 5, \"view\": "                 \
    "\"picture\", \"variants\": 3, \"scene\": " scene "}]}"
#define ALSO(names) "{" HEAD ", \"also right\": " names ", \"checks\": [{" CHECK ", \"variants\": 3}]}"

// What varies: lists and ranges, each of whose numbers must be in the knob's range.
static void test_choices(void **unused) {
    (void)unused;
    assert_fit(SIZE("[16, 4096]"), NULL);
    assert_fit(SIZE("{\"from\": 16, \"to\": 20.5}"), NULL);
    assert_fit(SCENE("[\"table spot\", \"table sun\"]"), NULL);
    assert_fit(ALSO("[\"a\"]"), NULL);
    assert_fit(SIZE("[16, 4097]"), "\"map size\": 4097 is outside");
    assert_fit(SIZE("{\"from\": 15, \"to\": 20}"), "\"map size\": 15 is outside");
    assert_fit(SIZE("{\"from\": 16, \"to\": 5000}"), "\"map size\": 5000 is outside");
    assert_refused(SIZE("\"16\""), "map size: ");
    assert_refused(SIZE("[]"), "map size: ");
    assert_refused(SIZE("[1, \"2\"]"), "map size: ");
    assert_refused(SIZE("[1, 2, 3, 4, 5, 6, 7]"), "map size: ");
    assert_refused(SIZE("{\"from\": 2, \"to\": 2}"), "write a larger number");
    assert_refused(SIZE("{\"from\": 2}"), "to");
    assert_refused(SCENE("[]"), "scene: ");
    assert_refused(SCENE("[1]"), "scene: ");
    assert_refused(SCENE("[\"table sun\", \"nowhere\"]"), "there is no scene \"nowhere\"");
    assert_refused(ALSO("[\"b\"]"), "alternatives.json has no \"b\"");
    assert_refused(ALSO("[2]"), "also right[0]: ");
}

static void assert_sources(const char *sources, int file, const char *text, const char *message) {
    char parent[FILES_PATH], folder[FILES_PATH], path[FILES_PATH];
    const char *texts[RUBRIC_FILES] = {good[0], "[]", "[]", "{}"};
    Rubric rubric;
    texts[file] = text;
    check_clear();
    assert_true(files_make_temporary(parent));
    files_join(folder, parent, "03-test/");
    assert_true(files_make_folder(folder));
    folder[strlen(folder) - 1] = '\0';
    files_join(path, folder, "lab.c");
    assert_true(files_write(path, sources));
    assert_true(rubric_read(&rubric, folder, texts));
    const bool fits = rubric_fit_sources(&rubric);
    if (fits != (message == NULL) || (message && !strstr(check_message(), message)))
        fail_msg("%s: %s", sources, check_message());
    rubric_destroy(&rubric);
    files_remove(parent);
}

static void test_fits_the_sources(void **unused) {
    static const char changes[] = "[{\"name\": \"a\", \"edits\": [" EDIT "]}]";
    (void)unused;
    assert_sources("#ifdef SOLUTION // 3.1\nx\ny\n#endif\n", ALTERNATIVES_JSON, changes, NULL);
    assert_sources("x\ny\n", ALTERNATIVES_JSON, changes,
                   "checks[0] \"c\": task: no source of the lab has a block \"#ifdef SOLUTION // 3.1\"");
    assert_sources("#ifdef SOLUTION // 3.1\nz\n#endif\n", ALTERNATIVES_JSON, changes,
                   "alternatives.json: [0] \"a\": edits[0]: find: the text to replace stands in lab.c "
                   "nowhere; copy a longer piece");
    assert_sources("#ifdef SOLUTION // 3.1\nx\ny\nx\ny\n#endif\n", ALTERNATIVES_JSON, changes,
                   "edits[0]: find: the text to replace stands in lab.c more than once");
    assert_sources("#ifdef SOLUTION // 3.1\nx\n#endif\n", MISTAKES_JSON, "[" MISTAKE "]",
                   "mistakes.json: [0] \"m\": edits: is missing");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_fits_the_lab), cmocka_unit_test(test_choices),
                                       cmocka_unit_test(test_fits_the_sources)};
    return cmocka_run_group_tests_name("rubric and lab", tests, NULL, NULL);
}
