#include "study/pareto.h"

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
        points[i].on_front = points[i].ms >= 0 && !points[i].aside;
        for (size_t j = 0; j < count; j++)
            if (points[j].ms >= 0 && !points[j].aside && pareto_dominates(&points[j], &points[i]))
                points[i].on_front = false;
    }
}
