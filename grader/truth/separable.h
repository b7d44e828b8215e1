// Filters that are the product of one along x and one along y.
#pragma once

#include "truth/metrics.h"

enum { SEPARABLE_MOST = 32 }; // radius

typedef struct SeparableKernel {
    int radius;
    float
        weights[2 * SEPARABLE_MOST + 1]; // 2 * radius + 1 of them; the first one for the pixel left or above
} SeparableKernel;

// Writes the filtered plane to `to`, which is another one. Beyond the borders stand the pixels at the border.
void separable_filter(MetricsSize size, const float *from, const SeparableKernel *along_x,
                      const SeparableKernel *along_y, float *to);
