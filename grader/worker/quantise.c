#include "worker/quantise.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

// To the nearest, and halves to the even one, as lrintf does: by adding a number so large that nothing behind
// the point is left. It is a step that the compiler does for several channels at once.
static uint8_t quantise_channel(float value) {
    const float large = 12582912;                                // 1.5 * 2^23
    const float clamped = value > 0 ? value < 1 ? value : 1 : 0; // 0 for what is no number
    const float sum = clamped * 255 + large;
    uint32_t bits;
    memcpy(&bits, &sum, sizeof bits);
    return (uint8_t)bits;
}

static void quantise_row(const float *from, uint8_t *to, size_t count) {
    for (size_t i = 0; i < count; i++)
        to[i] = quantise_channel(from[i]);
}

// Alpha says whether the colour is a finite number.
static void mark_row(const float *from, uint8_t *to, int width) {
    for (int x = 0; x < width; x++, from += 4, to += 4) {
        const bool finite = isfinite(from[0]) && isfinite(from[1]) && isfinite(from[2]);
        to[3] = 255;
        if (!finite)
            memset(to, 0, 4);
    }
}

void quantise(const float *colors, uint8_t *pixels, int width, int height) {
    const size_t row = 4 * (size_t)width;
    for (int y = 0; y < height; y++) {
        const float *from = colors + row * (size_t)(height - 1 - y);
        quantise_row(from, pixels + row * (size_t)y, row);
        mark_row(from, pixels + row * (size_t)y, width);
    }
}
