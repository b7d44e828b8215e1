#include "scene/samples.h"

#include "scene/random.h"

// The bits of i mirrored at the binary point.
static float radical_inverse(uint32_t i) {
    i = (i << 16) | (i >> 16);
    i = ((i & 0x00ff00ffu) << 8) | ((i & 0xff00ff00u) >> 8);
    i = ((i & 0x0f0f0f0fu) << 4) | ((i & 0xf0f0f0f0u) >> 4);
    i = ((i & 0x33333333u) << 2) | ((i & 0xccccccccu) >> 2);
    i = ((i & 0x55555555u) << 1) | ((i & 0xaaaaaaaau) >> 1);
    return (float)(i >> 8) * 0x1p-24f;
}

static float wrap(float x) {
    return x - floorf(x);
}

vec2s sample_pair(uint64_t seed, int i, int count) {
    Random random = {seed};
    float shift_x = random_range(&random, 0, 1), shift_y = random_range(&random, 0, 1);
    return (vec2s){
        {wrap(((float)i + 0.5f) / (float)count + shift_x), wrap(radical_inverse((uint32_t)i) + shift_y)}};
}
