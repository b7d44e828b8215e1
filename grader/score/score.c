// The two parts of a score, inside and outside of the masks, and plain metrics of pictures.
#include "score/score.h"

#include "scene/check.h"

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

// In 255ths: 0 within the tolerance, 255 where just one of them is not finite. Most pixels are equal.
static inline int difference_at(const Image *a, const Image *b, size_t at) {
    if (memcmp(a->rgba + at, b->rgba + at, 4) == 0)
        return 0;
    if (a->rgba[at + 3] != b->rgba[at + 3])
        return 255;
    int largest = 0;
    for (size_t c = 0; c < 3; c++) {
        int difference = abs(a->rgba[at + c] - b->rgba[at + c]);
        largest = difference > largest ? difference : largest;
    }
    return largest <= SCORE_TOLERANCE ? 0 : largest;
}

double score_pixel(const Image *a, const Image *b, size_t at) {
    return difference_at(a, b, at) / 255.0;
}

static bool same_size(const Image *a, const Image *b) {
    return a->width == b->width && a->height == b->height && a->rgba && b->rgba;
}

static bool same_bytes(const Image *a, const Image *b) {
    return memcmp(a->rgba, b->rgba, image_bytes(a)) == 0;
}

// Share of the mask's pixels that are wrong. One off by as much as the null picture, or by WHOLLY, is wholly
// wrong.
static double error_inside(const Image *yours, const Image *reference, const Image *null_image) {
    double error = 0;
    size_t pixels = 0;
    for (size_t at = 0, end = image_bytes(reference); at < end; at += 4) {
        int null_difference = difference_at(null_image, reference, at);
        if (null_difference == 0)
            continue;
        pixels++;
        int difference = difference_at(yours, reference, at);
        if (difference > 0)
            error += fmin(difference / 255.0 / fmin(null_difference / 255.0, WHOLLY), 1);
    }
    return pixels > 0 ? error / (double)pixels : 0;
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
            if (difference_at(p->without, p->reference, at) || difference_at(p->skeleton, p->reference, at))
                continue;
            error += difference_at(p->yours, p->reference, at) / 255.0;
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
    if (same_bytes(yours, reference))
        return (FrameScore){.share = 1};
    const Pictures pictures = {yours, reference, without, skeleton};
    FrameScore score = {
        .inside = fmax(error_inside(yours, reference, without), error_inside(yours, reference, skeleton)),
        .outside = error_outside(&pictures)};
    double error = score.inside + score.outside;
    score.share = fmin(fmax((ZERO - error) / (ZERO - FULL), 0), 1);
    return score;
}

bool score_is_any(const Image *yours, const Image *reference, const Image *without, const Image *skeleton) {
    INVARIANT(same_size(yours, reference) && same_size(reference, without) && same_size(reference, skeleton));
    return same_bytes(yours, reference) || (error_inside(yours, reference, without) < ZERO &&
                                            score_frame(yours, reference, without, skeleton).share > 0);
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
        count += difference_at(a, b, at) > 0;
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
