// Blurs one picture by boxes of growing size and looks how much of the difference to the other one is left.
#include "score/soft_kind.h"

#include "score/score.h"

#include <math.h>
#include <stdlib.h>

enum { CHANNELS = 3, MOST_BLUR = 8, COARSE_BLUR = 10 };

// A blur explains the error when at most so much of it is left: kernels of texels are no boxes of pixels.
static const double REST = 0.4;
// Steps that are other ones leave so much, which a shadow at another place does not.
static const double COARSE_REST = 0.6;
// It keeps the mean: the signed error is at most so much of the error.
static const double SIGNED = 0.4;
// An edge is sharp when its largest steps have this share of the contrast.
static const double SHARP = 0.35;
// Least error (of 255, a pixel) that can tell.
static const double LEAST = 0.2;

typedef struct Grey {
    int width, height;
    double *at; // brightness, 0 to 255
} Grey;

static bool grey_create(Grey *grey, const Image *image) {
    *grey = (Grey){image->width, image->height, calloc(image_bytes(image) / 4, sizeof *grey->at)};
    for (size_t i = 0; grey->at && i < image_bytes(image) / 4; i++) {
        double sum = 0;
        for (size_t c = 0; c < CHANNELS; c++)
            sum += image->rgba[4 * i + c];
        grey->at[i] = sum / CHANNELS;
    }
    return grey->at != NULL;
}

// The mean over the part of the line from -radius to radius that lies inside; the line's values are `step`
// apart.
static void blur_line(double *out, const double *in, int count, int step, int radius) {
    double sum = 0;
    int from = 0, to = 0;
    for (int i = 0; i < count; i++) {
        for (; to < count && to <= i + radius; to++)
            sum += in[to * step];
        for (; from < i - radius; from++)
            sum -= in[from * step];
        out[i * step] = sum / (to - from);
    }
}

// False when there is no memory. The caller frees out->at.
static bool blur(Grey *out, const Grey *in, int radius) {
    const size_t count = (size_t)in->width * (size_t)in->height;
    double *rows = calloc(count, sizeof *rows);
    *out = (Grey){in->width, in->height, calloc(count, sizeof *out->at)};
    for (int y = 0; rows && y < in->height; y++)
        blur_line(rows + y * in->width, in->at + y * in->width, in->width, 1, radius);
    for (int x = 0; rows && out->at && x < in->width; x++)
        blur_line(out->at + x, rows + x, in->height, in->width, radius);
    free(rows);
    return rows && out->at;
}

typedef struct Error {
    double size, sum; // mean of |a - b|, mean of a - b
} Error;

static Error error_between(const Grey *a, const Grey *b) {
    Error error = {0};
    const int count = a->width * a->height;
    for (int i = 0; i < count; i++) {
        error.size += fabs(a->at[i] - b->at[i]) / count;
        error.sum += (a->at[i] - b->at[i]) / count;
    }
    return error;
}

// What is left of the error between `sharp`, blurred by the best box, and `soft`.
static double left_by_blur(const Grey *sharp, const Grey *soft) {
    double least = INFINITY;
    for (int radius = 1; radius <= MOST_BLUR; radius += radius < 4 ? 1 : 2) {
        Grey blurred;
        if (blur(&blurred, sharp, radius))
            least = fmin(least, error_between(&blurred, soft).size);
        free(blurred.at);
    }
    return least;
}

// How sharp the edges are, where the two differ: the mean of the steps, weighed by themselves, of the
// contrast.
static double sharpness(const Grey *grey, const Grey *other) {
    double steps = 0, squares = 0, low = 255, high = 0;
    for (int y = 0; y + 1 < grey->height; y++)
        for (int x = 0; x + 1 < grey->width; x++) {
            const int i = y * grey->width + x;
            if (fabs(grey->at[i] - other->at[i]) <= SCORE_TOLERANCE)
                continue;
            const double step =
                fmax(fabs(grey->at[i + 1] - grey->at[i]), fabs(grey->at[i + grey->width] - grey->at[i]));
            steps += step;
            squares += step * step;
            low = fmin(low, fmin(grey->at[i], other->at[i]));
            high = fmax(high, fmax(grey->at[i], other->at[i]));
        }
    return steps > 0 && high > low ? squares / steps / (high - low) : 0;
}

static const char *softer(bool is_sharp, bool shadows) {
    if (is_sharp || !shadows)
        return "blurred: edges are soft that should be sharper";
    return "wider penumbra: the soft edge of the shadow is too wide";
}

static const char *sharper(bool shadows) {
    return shadows ? "narrower penumbra: the soft edge of the shadow is too narrow, or it is sharp"
                   : "too sharp, or in blocks: it should be smoother";
}

static const char *compare(const Grey *yours, const Grey *reference, bool shadows) {
    const Error error = error_between(yours, reference);
    if (error.size < LEAST || fabs(error.sum) > SIGNED * error.size)
        return NULL;
    const double soft = left_by_blur(reference, yours), sharp = left_by_blur(yours, reference);
    if (fmin(soft, sharp) > REST * error.size)
        return NULL;
    return soft < sharp ? softer(sharpness(reference, yours) > SHARP, shadows) : sharper(shadows);
}

const char *soft_kind(const Image *yours, const Image *reference, bool shadows) {
    Grey mine, right = {0};
    const char *kind = NULL;
    if (grey_create(&mine, yours) && grey_create(&right, reference))
        kind = compare(&mine, &right, shadows);
    free(mine.at);
    free(right.at);
    return kind;
}

// Both signs lie side by side along the edges: blurred, the two pictures are alike.
static bool is_right_on_the_whole(const Grey *yours, const Grey *reference) {
    Grey mine, right = {0};
    const Error error = error_between(yours, reference);
    bool alike = false;
    if (blur(&mine, yours, COARSE_BLUR) && blur(&right, reference, COARSE_BLUR))
        alike = error.size >= LEAST && error_between(&mine, &right).size <= COARSE_REST * error.size;
    free(mine.at);
    free(right.at);
    return alike;
}

const char *coarse_kind(const Image *yours, const Image *reference) {
    Grey mine, right = {0};
    bool coarse = false;
    if (grey_create(&mine, yours) && grey_create(&right, reference))
        coarse = is_right_on_the_whole(&mine, &right) && sharpness(&mine, &right) > SHARP;
    free(mine.at);
    free(right.at);
    return coarse ? "too coarse or too fine: right on the whole, but its edges have other steps" : NULL;
}
