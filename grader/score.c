#include "score.h"

#include "check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// A picture within FULL of the reference gets all points (an edge drawn in another rounding), one off by ZERO
// none.
static const double FULL = 0.02, ZERO = 0.25;

// A pixel in the mask that is off by this much (of 1) counts as wrong, not as partly right.
static const double WHOLLY = 0.05;

// A window says something about the picture outside the mask when at least this many of its pixels lie there.
enum { WINDOW_PIXELS = SCORE_WINDOW * SCORE_WINDOW / 4 };

static int channel_difference(const uint8_t *a, const uint8_t *b) {
    int largest = 0;
    for (int c = 0; c < 3; c++) {
        int difference = abs(a[c] - b[c]);
        largest = difference > largest ? difference : largest;
    }
    return largest;
}

double score_pixel(const Image *a, const Image *b, size_t at) {
    if (a->rgba[at + 3] != b->rgba[at + 3])
        return 1;
    int difference = channel_difference(a->rgba + at, b->rgba + at);
    return difference <= SCORE_TOLERANCE ? 0 : difference / 255.0;
}

static bool same_size(const Image *a, const Image *b) {
    return a->width == b->width && a->height == b->height && a->rgba && b->rgba;
}

// Share of the mask's pixels that are wrong. One off by as much as the null picture, or by WHOLLY, is wholly
// wrong.
static double error_inside(const Image *yours, const Image *reference, const Image *null_image) {
    double error = 0, pixels = 0;
    for (size_t at = 0, end = image_bytes(reference); at < end; at += 4) {
        double null_error = score_pixel(null_image, reference, at);
        if (null_error == 0)
            continue;
        error += fmin(score_pixel(yours, reference, at) / fmin(null_error, WHOLLY), 1);
        pixels++;
    }
    return pixels > 0 ? error / pixels : 0;
}

typedef struct Pictures {
    const Image *yours, *reference, *without, *skeleton;
} Pictures;

static double window_error(const Pictures *p, int left, int top) {
    double error = 0;
    int count = 0;
    for (int y = top; y < top + SCORE_WINDOW && y < p->reference->height; y++)
        for (int x = left; x < left + SCORE_WINDOW && x < p->reference->width; x++) {
            size_t at = image_at(p->reference, x, y);
            if (score_pixel(p->without, p->reference, at) > 0 ||
                score_pixel(p->skeleton, p->reference, at) > 0)
                continue;
            error += score_pixel(p->yours, p->reference, at);
            count++;
        }
    return count >= WINDOW_PIXELS ? error / count : 0;
}

static double error_outside(const Pictures *p) {
    double worst = 0;
    for (int top = 0; top < p->reference->height; top += SCORE_WINDOW)
        for (int left = 0; left < p->reference->width; left += SCORE_WINDOW)
            worst = fmax(worst, window_error(p, left, top));
    return worst;
}

FrameScore score_frame(const Image *yours, const Image *reference, const Image *without,
                       const Image *skeleton) {
    INVARIANT(same_size(yours, reference) && same_size(reference, without) && same_size(reference, skeleton));
    const Pictures pictures = {yours, reference, without, skeleton};
    FrameScore score = {
        .inside = fmax(error_inside(yours, reference, without), error_inside(yours, reference, skeleton)),
        .outside = error_outside(&pictures)};
    double error = score.inside + score.outside;
    score.share = fmin(fmax((ZERO - error) / (ZERO - FULL), 0), 1);
    return score;
}

double score_mask(const Image *reference, const Image *other) {
    return (double)score_count(reference, other) / ((double)image_bytes(reference) / 4);
}

double score_rmse(const Image *a, const Image *b) {
    if (!same_size(a, b))
        return 255;
    uint64_t sum = 0;
    for (size_t at = 0, end = image_bytes(a); at < end; at += 4) {
        int red = a->rgba[at] - b->rgba[at], green = a->rgba[at + 1] - b->rgba[at + 1];
        int blue = a->rgba[at + 2] - b->rgba[at + 2];
        sum += (unsigned)(red * red + green * green + blue * blue);
    }
    return sqrt((double)sum / ((double)image_bytes(a) * 0.75));
}

size_t score_count(const Image *a, const Image *b) {
    size_t count = 0;
    for (size_t at = 0, end = image_bytes(a); at < end; at += 4)
        count += score_pixel(a, b, at) > 0;
    return count;
}

const char *score_not_finite(const Image *image) {
    for (size_t at = 3; at < image_bytes(image); at += 4)
        if (image->rgba[at] == 0)
            return "some pixels are not finite numbers (NaN or infinity): is there a division by zero, a "
                   "pow of a negative number or a normalize of a zero vector in a shader?";
    return NULL;
}

void score_fill(Image *image, const uint8_t rgb[3]) {
    for (size_t at = 0; at < image_bytes(image); at += 4) {
        memcpy(image->rgba + at, rgb, 3);
        image->rgba[at + 3] = 255;
    }
}

void score_mean_color(const Image *image, uint8_t rgb[3]) {
    double sum[3] = {0}, pixels = (double)image_bytes(image) / 4;
    for (size_t at = 0; at < image_bytes(image); at += 4)
        for (int c = 0; c < 3; c++)
            sum[c] += image->rgba[at + (size_t)c];
    for (int c = 0; c < 3; c++)
        rgb[c] = (uint8_t)(sum[c] / pixels + 0.5);
}
