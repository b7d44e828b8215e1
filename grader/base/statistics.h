// What stands in the middle of many numbers.
#pragma once

#include <stddef.h>

// Median of `count` > 0 values, the mean of the middle two where their number is even. Sorts the values.
double statistics_median(double *values, size_t count);

// Median absolute deviation from the median (Hampel: The Influence Curve and Its Role in Robust Estimation,
// JASA 1974). Overwrites the values.
double statistics_mad(double *values, size_t count);

// The value that `percent` (0 to 99) of `count` > 0 values lie below. Sorts the values.
double statistics_percentile(double *values, size_t count, size_t percent);
