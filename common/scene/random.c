#include "scene/random.h"

uint64_t random_next(Random *random) {
    uint64_t z = random->state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

float random_range(Random *random, float low, float high) {
    float unit = (float)(random_next(random) >> 40) * 0x1p-24f;
    return low + unit * (high - low);
}

int random_int(Random *random, int low, int high) {
    return low + (int)(random_next(random) % (uint64_t)(high - low + 1));
}
