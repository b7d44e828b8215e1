// SipHash-2-4 against its authors' vectors: key 00 to 0f, input 00 01 02 ...
#include "base/siphash.h"
#include "scene/count.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static const uint64_t key[2] = {0x0706050403020100u, 0x0f0e0d0c0b0a0908u};

static void test_vectors(void **state) {
    (void)state;
    static const struct {
        size_t size;
        uint64_t hash;
    } vectors[] = {{0, 0x726fdb47dd0e0e31u},
                   {1, 0x74f839c593dc67fdu},
                   {8, 0x93f5f5799a932462u},
                   {15, 0xa129ca6149be45e5u}}; // the last is of the paper's appendix A
    unsigned char input[16];
    for (unsigned char i = 0; i < sizeof input; i++)
        input[i] = i;
    for (size_t i = 0; i < COUNT(vectors); i++)
        assert_int_equal(siphash(key, input, vectors[i].size), vectors[i].hash);
}

static void test_all_counts(void **state) {
    (void)state;
    assert_true(siphash(key, "a", 1) != siphash(key, "a", 2)); // the 0 behind it
    assert_true(siphash((const uint64_t[2]){key[0] + 1, key[1]}, "a", 1) != siphash(key, "a", 1));
    assert_true(siphash((const uint64_t[2]){key[0], key[1] + 1}, "a", 1) != siphash(key, "a", 1));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_vectors), cmocka_unit_test(test_all_counts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
