// A number made from content that nobody can foresee, or make come twice, without the key: SipHash-2-4
// (Aumasson, Bernstein: SipHash: a fast short-input PRF, INDOCRYPT 2012).
#pragma once

#include <stddef.h>
#include <stdint.h>

// The number of `size` bytes; the same for the same key and bytes on every machine.
uint64_t siphash(const uint64_t key[2], const void *bytes, size_t size);
