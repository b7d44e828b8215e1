#include "truth/separable.h"

#include "scene/check.h"

#include <stdlib.h>
#include <string.h>

static int at_border(int i, int count) {
    return i < 0 ? 0 : i < count ? i : count - 1;
}

// `line` has a border of the radius on both sides.
static void filter_row(const float *line, int width, const SeparableKernel *kernel, float *to) {
    for (int x = 0; x < width; x++)
        to[x] = 0;
    for (int k = 0; k <= 2 * kernel->radius; k++) {
        float weight = kernel->weights[k];
        for (int x = 0; x < width; x++)
            to[x] += weight * line[x + k];
    }
}

static void add_row(const float *row, int width, float weight, float *to) {
    for (int x = 0; x < width; x++)
        to[x] += weight * row[x];
}

void separable_filter(MetricsSize size, const float *from, const SeparableKernel *along_x,
                      const SeparableKernel *along_y, float *to) {
    size_t width = (size_t)size.width;
    float *half = malloc(width * (size_t)size.height * sizeof *half);
    float *line = calloc(width + 2 * SEPARABLE_MOST, sizeof *line);
    INVARIANT(half && line);
    for (int y = 0; y < size.height; y++) {
        for (int x = -along_x->radius; x < size.width + along_x->radius; x++)
            line[x + along_x->radius] = from[(size_t)y * width + (size_t)at_border(x, size.width)];
        filter_row(line, size.width, along_x, half + (size_t)y * width);
    }
    memset(to, 0, width * (size_t)size.height * sizeof *to);
    for (int y = 0; y < size.height; y++)
        for (int k = -along_y->radius; k <= along_y->radius; k++)
            add_row(half + (size_t)at_border(y + k, size.height) * width, size.width,
                    along_y->weights[k + along_y->radius], to + (size_t)y * width);
    free(half);
    free(line);
}
