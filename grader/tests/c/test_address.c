// What AddressSanitizer prints becomes one sentence, by the words of several versions of gcc; and what only
// looks like a report becomes nothing.
#include "grade/address_report.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static const Rubric rubric = {.files = {"lab.c", "offsets.h"}, .file_count = 2};

#define HEAD "hello\n====\n==7==ERROR: AddressSanitizer: "
#define STACK                                                                                                \
    "    #0 0x7f in memcpy ../../src/libsanitizer/x.cpp:12\n    #1 0x7f in bake /tmp/a b/lab.c:80\n    #2 "  \
    "0x7f in main main.c:3\n\n"

static void check(const char *printed, const char *expected) {
    char text[800] = "";
    const bool found = address_report_read(text, sizeof text, printed, &rubric);
    assert_int_equal(found, expected != NULL);
    if (expected)
        assert_string_equal(text, expected);
}

static void test_heap(void **unused) {
    (void)unused;
    static const char *const made =
        "allocated by thread T0 here:\n    #0 0x7f in malloc m.cpp:6\n    #1 0x7f in fill offsets.h:9\n\n";
    static const struct {
        const char *words, *expected;
    } cases[] = {
        {"0x62 is located 0 bytes to the right of 64-byte region [0x1,0x2)\n",
         ", just past the end of an array of 64 bytes, made at offsets.h:9"},
        {"0x62 is located 0 bytes after 64-byte region [0x1,0x2)\n",
         ", just past the end of an array of 64 bytes, made at offsets.h:9"},
        {"0x62 is located 8 bytes to the left of 64-byte region [0x1,0x2)\n",
         ", 8 bytes before the start of an array of 64 bytes, made at offsets.h:9"},
        {"0x62 is located 8 bytes before 64-byte region [0x1,0x2)\n",
         ", 8 bytes before the start of an array of 64 bytes, made at offsets.h:9"},
        {"0x62 is located 4 bytes inside of 64-byte region [0x1,0x2)\n",
         " of an array of 64 bytes, made at offsets.h:9"},
    };
    for (unsigned i = 0; i < COUNT(cases); i++) {
        char printed[2000], expected[400];
        snprintf(printed, sizeof printed,
                 HEAD "heap-buffer-overflow on address 0x62\nWRITE of size 4 at 0x62 thread T0\n" STACK
                      "%s%s",
                 cases[i].words, made);
        snprintf(expected, sizeof expected, "heap-buffer-overflow in bake (lab.c:80): writes 4 bytes%s",
                 cases[i].expected);
        check(printed, expected);
    }
}

static void test_others(void **unused) {
    (void)unused;
    check(HEAD "stack-buffer-overflow on address 0x62\nREAD of size 1 at 0x62 thread T0\n" STACK
               "Address 0x62 is located in stack of thread T0 at offset 48 in frame\n    #0 0x7f in bake "
               "lab.c:70\n\n"
               "  This frame has 2 object(s):\n    [32, 48) 'weights' (line 71) <== Memory access at offset "
               "48 overflows\n",
          "stack-buffer-overflow in bake (lab.c:80): reads 1 byte, outside of weights, which is defined in "
          "line 71");
    check(HEAD "global-buffer-overflow on address 0x62\nWRITE of size 4 at 0x62 thread T0\n" STACK
               "0x62 is located 0 bytes to the right of global variable 'table' defined in './lab.c:4:12' "
               "(0x7) of size 32\n",
          "global-buffer-overflow in bake (lab.c:80): writes 4 bytes, outside of table");
    check(HEAD "SEGV on unknown address 0x000000000000\nHint: address points to the zero page.\n" STACK,
          "SEGV in bake (lab.c:80): through a pointer that is NULL, or nearly");
}

static void test_no_report(void **unused) {
    (void)unused;
    check("", NULL);
    check("ERROR: AddressSanitizer: ", NULL);
    check(HEAD "heap-buffer-overflow", NULL);
    check(HEAD "heap-buffer-overflow on address 0x62\n    #0 0x7f in main /src/main.c:3\n\n    #1 0x7f in "
               "bake lab.c:3\n",
          NULL);
    check(HEAD "ABRT on unknown address 0x62\n" STACK, NULL); // says no more than the crash did
    check(HEAD "SEGV on unknown address\n    #0 ", NULL);
    check(HEAD "SEGV on unknown address\n    #0 0x7f in bake lab.c:\n", NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_heap), cmocka_unit_test(test_others),
                                       cmocka_unit_test(test_no_report)};
    return cmocka_run_group_tests_name("address", tests, NULL, NULL);
}
