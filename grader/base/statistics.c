#include "base/statistics.h"

#include "scene/check.h"

#include <math.h>
#include <stdlib.h>

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double statistics_median(double *values, size_t count) {
    INVARIANT(count > 0);
    qsort(values, count, sizeof *values, by_value);
    return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

double statistics_mad(double *values, size_t count) {
    double median = statistics_median(values, count);
    for (size_t i = 0; i < count; i++)
        values[i] = fabs(values[i] - median);
    return statistics_median(values, count);
}

double statistics_percentile(double *values, size_t count, size_t percent) {
    INVARIANT(count > 0 && percent < 100);
    qsort(values, count, sizeof *values, by_value);
    return values[count * percent / 100];
}
