// The description of a lab that an untrusted worker sends.
#include "protocol/description.h"

#include "scene/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

// What a hostile worker may send.
static void test_description(void **unused) {
    (void)unused;
    static Description bad;
    memset(&bad, 'x', sizeof bad);
    bad.knob_count = 1 << 20;
    bad.pass_count = -5;
    bad.pass_kinds[0] = PASS_SHOW, bad.pass_kinds[1] = -1, bad.pass_kinds[2] = 77;
    bad.knobs[0].choice_count = -3, bad.knobs[1].choice_count = 1 << 20;
    bad.title[0] = '\033';
    bad.knobs[0].low = NAN;
    bad.knobs[1].low = 5, bad.knobs[1].high = 1;
    bad.knobs[2].low = 0, bad.knobs[2].high = 1, bad.knobs[2].value = INFINITY;
    bad.knobs[3].low = 0, bad.knobs[3].high = 1, bad.knobs[3].value = 9;
    description_clean(&bad);
    assert_true(bad.knob_count == LAB_MAX_KNOBS && bad.pass_count == 0 && bad.stage_count == LAB_MAX_STAGES);
    assert_int_equal(strlen(bad.title), sizeof bad.title - 1);
    assert_true(bad.title[0] == '?');
    assert_int_equal(strlen(bad.stages[LAB_MAX_STAGES - 1]), LAB_MAX_NAME - 1);
    assert_true(bad.pass_kinds[0] == PASS_SHOW && bad.pass_kinds[1] == PASS_PICTURE &&
                bad.pass_kinds[2] == PASS_PICTURE);
    assert_true(bad.knobs[0].choice_count == 0 && bad.knobs[1].choice_count == LAB_MAX_CHOICES);
    assert_int_equal(strlen(bad.knobs[1].choices[LAB_MAX_CHOICES - 1]), LAB_MAX_NAME - 1);
    for (int i = 0; i < 2; i++)
        assert_true(bad.knobs[i].low == 0 && bad.knobs[i].high == 0 && bad.knobs[i].value == 0);
    assert_true(bad.knobs[2].value == 0 && bad.knobs[3].value == 1);
}

static bool fits(const char *name, float value) {
    static Description lab;
    Request request = {.knob_count = 1, .knobs = {{.value = value}}};
    lab = (Description){.knob_count = 2,
                        .knobs = {{.name = "size", .low = 64, .high = 4096},
                                  {.name = "method", .low = 0, .high = 5, .choice_count = 6}}};
    snprintf(request.knobs[0].name, sizeof request.knobs[0].name, "%s", name);
    check_clear();
    return description_fits(&lab, &request);
}

static void test_fits(void **unused) {
    (void)unused;
    assert_true(fits("size", 64) && fits("size", 4096) && fits("size", 100.5f) && fits("method", 5));
    assert_false(fits("size", 63.9f));
    assert_non_null(strstr(check_message(), "\"size\" takes a number from 64 to 4096, not 63.9"));
    assert_false(fits("size", 4097));
    assert_false(fits("size", NAN));
    assert_false(fits("method", 1.5f));
    assert_non_null(strstr(check_message(), "a whole number from 0 to 5"));
    assert_false(fits("siz", 64));
    assert_non_null(strstr(check_message(), "no knob \"siz\"; its knobs are \"size\", \"method\""));
    check_clear();
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_description), cmocka_unit_test(test_fits)};
    return cmocka_run_group_tests_name("description", tests, NULL, NULL);
}
