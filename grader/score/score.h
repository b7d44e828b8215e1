// How wrong a picture is, from the pixels alone. README.md beside it gives the reasons. No GL.
//
// Interface: score_frame scores a picture against three of ours; score_pixel, score_count, score_rmse and
// score_mask compare two pictures; score_not_finite looks at one. Pure functions, from any thread.
#pragma once

#include "scene/image.h"

#include <stdbool.h>

enum {
    SCORE_TOLERANCE = 2, // of 255: channels this near are equal
    SCORE_WINDOW = 16    // side of the windows in which errors outside the mask are averaged
};

#define SCORE_PASSED 0.95 // a check with this share of its points is passed

typedef struct FrameScore {
    double inside;  // share of wrong pixels among those that the task, or the whole lab, changes: the larger,
                    // 0..1
    double outside; // mean error of the worst window of all other pixels, 0..1
    double
        share; // of the points: 1 for the reference, 0 for the solution without the task and for the skeleton
} FrameScore;

// Difference of two pixels: the largest channel difference in 0..1, 0 within the tolerance, 1 where just one
// of them is not finite. Both of the pictures' pixels at byte offset `at`.
double score_pixel(const Image *a, const Image *b, size_t at);

// Scores `yours`. `without` is the picture of the solution without the task in question, `skeleton` that of
// the skeleton; where they differ from the reference are the two masks. All have one size.
FrameScore score_frame(const Image *yours, const Image *reference, const Image *without,
                       const Image *skeleton);

// Is the share of points that score_frame gives more than 0? The same answer, sooner.
bool score_is_any(const Image *yours, const Image *reference, const Image *without, const Image *skeleton);

// Share of the pixels in which the two differ, 0..1.
double score_mask(const Image *reference, const Image *other);

// Root mean square of all channel differences, in units of 255 (0..255); a missing picture is 255 away.
double score_rmse(const Image *a, const Image *b);

// Number of pixels that differ by more than the tolerance.
size_t score_count(const Image *a, const Image *b);

// What to tell of a picture with pixels that are not finite numbers; NULL when all are.
const char *score_not_finite(const Image *image);

// Fills `image` with one colour.
void score_fill(Image *image, const uint8_t rgb[3]);

// The mean colour of a picture.
void score_mean_color(const Image *image, uint8_t rgb[3]);
