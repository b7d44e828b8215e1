// Tries each simple change of the picture and counts the pixels that are still wrong after it.
#include "score/whole_kind.h"

#include "score/score.h"

#include <math.h>
#include <stdlib.h>

enum { BLOCK = 4 };

// At most this share of the wrong pixels, or of the error, may be left over.
static const double REST = 0.2;
// A fit says something when the pictures differ by this much (of 255), and the reference is not of one
// colour.
static const double LEAST = 3, SPREAD = 12;

static bool differs(const uint8_t *a, const uint8_t *b) {
    return abs(a[0] - b[0]) + abs(a[1] - b[1]) + abs(a[2] - b[2]) > 3 * SCORE_TOLERANCE;
}

static double wrong_when_mirrored(const Image *yours, const Image *reference) {
    double wrong = 0;
    for (int y = 0; y < yours->height; y++)
        for (int x = 0; x < yours->width; x++)
            wrong += differs(yours->rgba + image_at(yours, yours->width - 1 - x, y),
                             reference->rgba + image_at(reference, x, y));
    return wrong;
}

// A fit of all pixels that are not cut off: yours = scale * reference + shift.
typedef struct Fit {
    double n, x, y, xx, xy;
    double scale, shift;
    double spread;        // of the reference: its standard deviation
    double before, after; // mean error of a channel without the fit, and with it
} Fit;

static void add_value(Fit *fit, double yours, double reference) {
    if (yours == 0 || yours == 255) // may be cut off
        return;
    fit->n++;
    fit->x += reference;
    fit->y += yours;
    fit->xx += reference * reference;
    fit->xy += reference * yours;
}

static Fit fit_all(const Image *yours, const Image *reference) {
    Fit fit = {0};
    const size_t bytes = image_bytes(yours);
    for (size_t i = 0; i < bytes; i++)
        if (i % 4 < 3)
            add_value(&fit, yours->rgba[i], reference->rgba[i]);
    const double n = fmax(fit.n, 1), variance = n * fit.xx - fit.x * fit.x;
    fit.spread = sqrt(fmax(variance, 0)) / n;
    fit.scale = variance > 0 ? (n * fit.xy - fit.x * fit.y) / variance : 0;
    fit.shift = (fit.y - fit.scale * fit.x) / n;
    for (size_t i = 0; i < bytes; i++) {
        const double said = fmin(fmax(fit.scale * reference->rgba[i] + fit.shift, 0), 255);
        fit.before += i % 4 < 3 ? abs(yours->rgba[i] - reference->rgba[i]) : 0;
        fit.after += i % 4 < 3 ? fabs(said - yours->rgba[i]) : 0;
    }
    fit.before /= 0.75 * (double)bytes;
    fit.after /= 0.75 * (double)bytes;
    return fit;
}

static const char *fitted_kind(const Image *yours, const Image *reference) {
    const Fit fit = fit_all(yours, reference);
    if (fit.before < LEAST || fit.after > REST / 2 * fit.before || fit.spread < SPREAD)
        return NULL;
    if (fit.scale < -0.8 && fit.scale > -1.2)
        return "inverted: bright and dark are exchanged";
    if (fit.scale > 0.05 && fabs(fit.scale - 1) > 0.05 && fabs(fit.shift) < LEAST)
        return fit.scale < 1 ? "a factor: the same picture, but each value is too small by the same factor"
                             : "a factor: the same picture, but each value is too large by the same factor";
    if (fabs(fit.scale - 1) < 0.05)
        return fit.shift > 0 ? "the same picture, but brighter by the same amount everywhere"
                             : "the same picture, but darker by the same amount everywhere";
    return NULL;
}

static const char *channel_kind(const Image *yours, const Image *reference, double wrong) {
    double by_channel[3] = {0};
    for (size_t at = 0; at < image_bytes(yours); at += 4)
        for (size_t c = 0; c < 3; c++)
            by_channel[c] += abs(yours->rgba[at + c] - reference->rgba[at + c]) > SCORE_TOLERANCE;
    const double sum = by_channel[0] + by_channel[1] + by_channel[2];
    static const char *const kinds[] = {"one channel only: red is wrong, green and blue are right",
                                        "one channel only: green is wrong, red and blue are right",
                                        "one channel only: blue is wrong, red and green are right"};
    for (int c = 0; c < 3; c++)
        if (wrong > 0 && sum - by_channel[c] < 0.02 * by_channel[c])
            return kinds[c];
    return NULL;
}

typedef struct Block {
    int wrong;        // pixels
    int change, size; // sum of the differences of their brightness, and of their sizes
} Block;

static Block look_at_block(const Image *yours, const Image *reference, int x, int y) {
    Block block = {0};
    for (int i = 0; i < BLOCK * BLOCK; i++) {
        const size_t at = image_at(yours, x + i % BLOCK, y + i / BLOCK);
        const uint8_t *a = yours->rgba + at, *b = reference->rgba + at;
        const int change = a[0] + a[1] + a[2] - b[0] - b[1] - b[2];
        block.wrong += differs(a, b);
        block.change += change;
        block.size += abs(change);
    }
    return block;
}

// Of the blocks that hold wrong pixels, the share whose mean is right within some noise: too bright and too
// dark pixels cancel out.
static double right_on_average(const Image *yours, const Image *reference) {
    double blocks = 0, right = 0;
    for (int y = 0; y + BLOCK <= yours->height; y += BLOCK)
        for (int x = 0; x + BLOCK <= yours->width; x += BLOCK) {
            const Block block = look_at_block(yours, reference, x, y);
            const bool cancels = 2 * abs(block.change) <= block.size &&
                                 abs(block.change) <= 3 * BLOCK * BLOCK * 3 * SCORE_TOLERANCE;
            blocks += block.wrong > BLOCK;
            right += block.wrong > BLOCK && cancels;
        }
    return blocks >= 8 ? right / blocks : 0;
}

const char *whole_kind(const Image *yours, const Image *reference, double wrong) {
    if (wrong_when_mirrored(yours, reference) < REST * wrong)
        return "mirrored: left and right are exchanged";
    const char *kind = channel_kind(yours, reference, wrong);
    return kind ? kind : fitted_kind(yours, reference);
}

const char *average_kind(const Image *yours, const Image *reference) {
    return right_on_average(yours, reference) > 1 - REST
               ? "right on average, but coarser or finer steps, or not the given random numbers, or not in "
                 "their order"
               : NULL;
}
