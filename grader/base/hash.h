// Names made from content: FNV-1a (Fowler, Noll, Vo), 64 bits.
#pragma once

#include <stddef.h>
#include <stdint.h>

#define HASH_START 0xcbf29ce484222325u

// Goes on from `hash` over the bytes.
uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size);
