// How far a method's visibility is from the truth. Pure functions of arrays; neither GL nor rays. All
// pictures have the same size, row after row; visibility is 0 (dark) to 1 (lit).
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define METRICS_NO_PRIMITIVE ((int32_t)-1)
#define METRICS_LEAST_FACING 0.05F // N.L: shaders/lighting.glsl draws less as turned away
#define METRICS_LEAST_EDGE 2.0F    // pixels

typedef struct MetricsSize {
    int width, height;
} MetricsSize;

// One part of a comparison. Sums are divided by the pixels of the whole mask, so that those of edge and
// interior add up to those of all (of rmse: the squares).
typedef struct MetricsPart {
    double false_shadow; // mean of max(truth - measured, 0); interior: acne
    double false_light;  // mean of max(measured - truth, 0); interior: leaks, peter-panning
    double mae;          // false_shadow + false_light
    double bias;         // false_light - false_shadow
    double rmse;
    size_t pixels; // of this part
} MetricsPart;

typedef struct Metrics {
    MetricsPart all, edge, interior;
} Metrics;

// What says which pixels count, per pixel.
typedef struct MetricsPixels {
    const int32_t *drawn;  // what GL drew there: metrics_primitive
    const int32_t *traced; // what the ray met
    const float *facing;   // N.L
    const float *measured; // the method's visibility
} MetricsPixels;

// One number for a triangle (0..65535) of an object (0..32767); METRICS_NO_PRIMITIVE for a negative object.
int32_t metrics_primitive(int object, int triangle);

// Decodes a pixel of the worker's view "primitives" (VIEW_PRIMITIVES in protocol.h).
int32_t metrics_decode_primitive(const uint8_t rgba[4]);

// Object of a primitive, -1 for none.
int metrics_object(int32_t primitive);

// The mask M: 1 where the same primitive was drawn and traced, N.L > METRICS_LEAST_FACING, all eight
// neighbours (in the picture) belong to the same object, so that the pixel is more than one pixel from a
// silhouette (all our meshes are convex), and the measured value is finite. Returns the number of ones.
size_t metrics_mask(MetricsSize size, const MetricsPixels *pixels, uint8_t *mask);

// Distance of each pixel's centre to the true boundary, in pixels: the boundary runs between neighbours of
// one object whose true visibility lies on different sides of 1/2, half a pixel from each. INFINITY where
// there is none. Exact Euclidean distances to the pixels at the boundary, plus that half (Felzenszwalb,
// Huttenlocher: Distance Transforms of Sampled Functions, Theory of Computing 2012). False with a message
// when there is no memory.
bool metrics_boundary(MetricsSize size, const int32_t *traced, const float *truth, float *distance);

// Half width of the edge: at least METRICS_LEAST_EDGE, else the method's kernel and one texel, all in pixels.
float metrics_edge_width(float kernel, float texel);

// Compares the pixels of the mask; `edge` are those at most edge_width from the boundary.
Metrics metrics_compare(MetricsSize size, const uint8_t *mask, const float *measured, const float *truth,
                        const float *distance, float edge_width);
