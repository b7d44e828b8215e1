// The description of a lab that an untrusted worker sends.
#include "protocol/description.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_description)};
    return cmocka_run_group_tests_name("description", tests, NULL, NULL);
}
