#include "score/error_kind.h"

#include "score/score.h"

#include <stdlib.h>

enum { STEP = 24 }; // of the sum of three channels: a smaller step is no edge

// So many pixels must lie at edges, and so much of their steps may be left in a picture without them.
static const double LEAST = 40, LEFT = 0.1;

typedef struct Steps {
    double edges, reference, without, yours; // the number of edges, and the sums of the steps over them
} Steps;

static int step(const Image *image, size_t a, size_t b) {
    int sum = 0;
    for (size_t i = 0; i < 3; i++)
        sum += image->rgba[a + i] - image->rgba[b + i];
    return abs(sum);
}

// The edge of the shadow lies between a pixel that the shadow changes and one that it does not.
static void add_step(Steps *steps, const Image *yours, const Image *reference, const Image *without, size_t a,
                     size_t b) {
    if ((score_pixel(reference, without, a) > 0) == (score_pixel(reference, without, b) > 0) ||
        step(reference, a, b) < STEP)
        return;
    steps->edges++;
    steps->reference += step(reference, a, b);
    steps->without += step(without, a, b);
    steps->yours += step(yours, a, b);
}

bool error_kind_lost_edges(const Image *yours, const Image *reference, const Image *without) {
    Steps steps = {0};
    for (int y = 0; y + 1 < yours->height; y++)
        for (int x = 0; x + 1 < yours->width; x++) {
            const size_t at = image_at(yours, x, y);
            add_step(&steps, yours, reference, without, at, image_at(yours, x + 1, y));
            add_step(&steps, yours, reference, without, at, image_at(yours, x, y + 1));
        }
    return steps.edges >= LEAST && steps.without < steps.reference / 2 &&
           steps.yours <= steps.without + LEFT * (steps.reference - steps.without);
}
