// Points of time and error: their noise, and which of them no other one beats. Pure functions.
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct Point {
    double ms, mad; // median of the frames' times and its error bar to both sides (MAD)
    double error;   // 0..1
    bool on_front;
    bool aside; // takes no part: its time is not like the others'
} Point;

// The smallest relative difference of two errors that counts: less may come from the truth's own samples.
#define PARETO_ERROR_NOISE 0.01

// Are a's times below b's, error bars included?
bool pareto_surely_faster(const Point *a, const Point *b);

// Do the error bars of their times overlap?
bool pareto_bars_overlap(const Point *a, const Point *b);

// Does a dominate b: it is not slower and errs no more, and one of the two by more than the noise?
bool pareto_dominates(const Point *a, const Point *b);

// Sets on_front of those points that no other one dominates. Points with a negative time and those aside do
// not take part.
void pareto_mark(Point *points, size_t count);
