#include "worker/quantise.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

static uint8_t quantise_channel(float value) {
    float clamped = value < 0 ? 0 : value > 1 ? 1 : value;
    return (uint8_t)lrintf(clamped * 255);
}

void quantise(const float *colors, uint8_t *pixels, int width, int height) {
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            const float *from = colors + 4 * ((size_t)(height - 1 - y) * (size_t)width + (size_t)x);
            uint8_t *to = pixels + 4 * ((size_t)y * (size_t)width + (size_t)x);
            bool finite = isfinite(from[0]) && isfinite(from[1]) && isfinite(from[2]);
            for (int c = 0; c < 3; c++)
                to[c] = finite ? quantise_channel(from[c]) : 0;
            to[3] = finite ? 255 : 0;
        }
}
