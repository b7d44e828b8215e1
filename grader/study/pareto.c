#include "study/pareto.h"

#include "scene/check.h"

#include <math.h>
#include <stdlib.h>

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

double pareto_median(double *values, int count) {
    INVARIANT(count > 0);
    qsort(values, (size_t)count, sizeof *values, compare);
    return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

double pareto_mad(double *values, int count) {
    double median = pareto_median(values, count);
    for (int i = 0; i < count; i++)
        values[i] = fabs(values[i] - median);
    return pareto_median(values, count);
}

bool pareto_surely_faster(const Point *a, const Point *b) {
    return a->ms + a->mad < b->ms - b->mad;
}

bool pareto_bars_overlap(const Point *a, const Point *b) {
    return !pareto_surely_faster(a, b) && !pareto_surely_faster(b, a);
}

bool pareto_dominates(const Point *a, const Point *b) {
    bool surely_better = a->error < b->error * (1 - PARETO_ERROR_NOISE);
    return a->ms <= b->ms && a->error <= b->error && (surely_better || pareto_surely_faster(a, b));
}

void pareto_mark(Point *points, size_t count) {
    for (size_t i = 0; i < count; i++) {
        points[i].on_front = points[i].ms >= 0;
        for (size_t j = 0; j < count; j++)
            if (points[j].ms >= 0 && pareto_dominates(&points[j], &points[i]))
                points[i].on_front = false;
    }
}
