// FLIP: how much two pictures differ to a person who flips between them (Andersson, Nilsson, Akenine-Moeller,
// Oskarsson, Astrom, Fairchild: FLIP: A Difference Evaluator for Alternating Images, HPG 2020), as its
// authors set it: a screen of 3840 pixels, 0.7 m wide, seen from 0.7 m. Written anew from the paper. Pure
// functions of arrays.
#pragma once

#include "truth/metrics.h"

// What the comparison needs of one picture. Arrays are owned.
typedef struct FlipPicture {
    MetricsSize size;
    float *color;        // L*, a, b of each pixel, seen from that distance; a and b with Hunt's adjustment
    float *edge, *point; // strength of edges and of points, per pixel
} FlipPicture;

// `rgb` holds linear light, three numbers a pixel; what is outside 0..1 is clamped. False with a message when
// there is no memory.
bool flip_create(FlipPicture *picture, MetricsSize size, const float *rgb);
void flip_destroy(FlipPicture *picture); // accepts a zeroed picture

// The same for a grey picture of one number a pixel.
bool flip_create_grey(FlipPicture *picture, MetricsSize size, const float *grey);

// The difference at pixel i of two pictures of one size, 0..1.
float flip_at(const FlipPicture *reference, const FlipPicture *test, size_t i);

// The mean over the pixels where the mask is 1 (NULL: over all), the figure that its authors recommend.
double flip_mean(const FlipPicture *reference, const FlipPicture *test, const uint8_t *mask);
