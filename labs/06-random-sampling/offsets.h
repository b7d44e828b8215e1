// The pattern: for each pixel of a small square, samples at random places of a disc, kept in a 3D texture.
#pragma once

#include "lab.h"

#include <stdlib.h>

enum { PATTERN_SEED = 6 };

typedef struct Pattern {
    GLuint offsets;    // 3D texture of size x size x layers texels: task 6.1
    int size;          // the pattern repeats every so many pixels
    int columns, rows; // the grid of a pixel's samples, one in each cell
    int layers;        // two samples each
    bool spiral;       // another arrangement, to compare with
    bool anywhere;     // another one: no cells, each sample anywhere in the square
} Pattern;

// Where sample k lies in the unit square. Both coordinates of `jitter` are random in [-0.5, 0.5).
static vec2s square_from_sample(const Pattern *pattern, int k, vec2s jitter) {
    // TODO(6.3): cut the square into pattern->columns x pattern->rows cells and put sample k into a cell of
    // its own: into column k mod columns, and into the last row (v near 1) first, the row below after it, and
    // so on. It lies in the middle of its cell, moved by `jitter`, whose unit is one cell.
    UNUSED(pattern, k);
    return (vec2s){{jitter.x + 0.5f, jitter.y + 0.5f}};
}

// From (u, v) in the unit square to the disc of radius 1 around (0, 0), evenly.
static vec2s disc_from_square(vec2s square) {
    // TODO(6.2): u goes once around the disc; v becomes the square of the distance to the
    // centre. Look up: sqrtf, cosf.
    return (vec2s){{2 * square.x - 1, 2 * square.y - 1}};
}

// Given: the samples along a spiral from the rim to the centre, turned by another angle for each pixel. Looks
// orderly, but is not even: half of the samples lie on a quarter of the disc.
static vec2s spiral_from_sample(const Pattern *pattern, int k, int pixel) {
    float radius = 1 - (float)k / (float)(2 * pattern->layers), angle = 2.4f * (float)k + 0.7f * (float)pixel;
    return (vec2s){{radius * cosf(angle), radius * sinf(angle)}};
}

// A texel is four floats: x and y of two samples. Texels follow each other along x, then y, then the layers.
static void fill_offsets(const Pattern *pattern, float *texels) {
    Random random = {PATTERN_SEED};
    for (int y = 0; y < pattern->size; y++)
        for (int x = 0; x < pattern->size; x++)
            for (int k = 0; k < 2 * pattern->layers; k++) {
                vec2s jitter;
                jitter.x = random_range(&random, -0.5f, 0.5f);
                jitter.y = random_range(&random, -0.5f, 0.5f);
                vec2s offset = disc_from_square(square_from_sample(pattern, k, jitter));
                if (pattern->anywhere)
                    offset = disc_from_square((vec2s){{jitter.x + 0.5f, jitter.y + 0.5f}});
                if (pattern->spiral)
                    offset = spiral_from_sample(pattern, k, y * pattern->size + x);
                int at = 0;
                // TODO(6.1): sample k of pixel (x, y) belongs into layer k / 2, into the texel's first half
                // when k is even and into its second half when k is odd. `at` counts floats.
                texels[at] = offset.x;
                texels[at + 1] = offset.y;
            }
}

static bool pattern_create(Pattern *pattern) {
    float *texels = calloc((size_t)(pattern->size * pattern->size * pattern->layers) * 4, sizeof *texels);
    if (!texels)
        return check_fail("out of memory for the offsets");
    fill_offsets(pattern, texels);
    // TODO(6.1), second part: make the 3D texture pattern->offsets from `texels`, with 32-bit floats
    // (they are negative, too) and without mipmaps. Look up: glTexImage3D, GL_RGBA32F,
    // glTexParameteri with GL_TEXTURE_MIN_FILTER.
    free(texels);
    return true;
}
