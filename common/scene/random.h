// Random numbers that are the same on every machine: splitmix64 (Steele, Lea, Flood: Fast Splittable
// Pseudorandom Number Generators, OOPSLA 2014, fig. 14).
#pragma once

#include <stdint.h>

typedef struct Random {
    uint64_t state;
} Random;

// 64 uniform bits.
uint64_t random_next(Random *random);

// Uniform in [low, high).
float random_range(Random *random, float low, float high);

// Uniform in low..high, both included.
int random_int(Random *random, int low, int high);
