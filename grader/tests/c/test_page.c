// What pages show of a text: nothing of it is markup, and what stands between backticks is code.
#include "pages/page.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void assert_shown(const char *text, const char *shown) {
    Page page = {0};
    page.out = open_memstream(&page.text, &page.size);
    assert_non_null(page.out);
    page_prose(&page, text);
    assert_int_equal(fclose(page.out), 0);
    assert_string_equal(page.text, shown);
    free(page.text);
}

static void test_prose(void **unused) {
    (void)unused;
    assert_shown("", "");
    assert_shown("in `a` (b)", "in <code>a</code> (b)");
    assert_shown("`a` and `b<c`.", "<code>a</code> and <code>b&lt;c</code>.");
    assert_shown("<b>, `open & \"on\"", "&lt;b&gt;, `open &amp; &quot;on&quot;");
    assert_shown("``", "<code></code>");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_prose)};
    return cmocka_run_group_tests_name("page", tests, NULL, NULL);
}
