// A measured curve, what it should be, and whether it is that. Pure numbers.
#pragma once

#include <stdbool.h>

enum { CURVE_POINTS = 40, FIGURE_CURVES = 6 };

typedef enum CurveRule {
    CURVE_EQUAL,  // each point is within its tolerance of what is expected
    CURVE_LEAST,  // each is at least expected - tolerance: a failure that must show
    CURVE_MOST,   // each is at most expected + tolerance
    CURVE_SLOPE,  // a power law: its exponent is within `tolerance` of `slope`
    CURVE_RISING, // no point is lower than the one before by more than its tolerance, and the last is higher
                  // than the first by more than that
    CURVE_FALLING
} CurveRule;

typedef struct CurvePoint {
    double x, measured, expected, tolerance;
} CurvePoint;

typedef struct Curve {
    const char *name;
    CurveRule rule;
    double slope, tolerance; // CURVE_SLOPE
    CurvePoint points[CURVE_POINTS];
    int count;
} Curve;

// Curves over the same axes. Labels have units.
typedef struct Figure {
    const char *title, *x_label, *y_label;
    bool log_x, log_y;
    Curve curves[FIGURE_CURVES];
    int count;
} Figure;

// `measured`, `expected` and `tolerance` are those of the point that is worst off (among equals the one that
// expects most), or the exponents of a slope. `share` is how much of the tolerance is used there: at most 1
// when the curve holds, CURVE_HOPELESS for a curve without points, with a value that is not finite, or off
// where nothing is tolerated.
typedef struct CurveVerdict {
    bool holds;
    double measured, expected, tolerance, share;
} CurveVerdict;

#define CURVE_HOPELESS 1e6

// A new empty curve of the figure. Abort when it is full.
Curve *figure_curve(Figure *figure, const char *name, CurveRule rule);

// Appends a point; for CURVE_SLOPE, CURVE_RISING and CURVE_FALLING `expected` does not count. Abort when the
// curve is full.
void curve_add(Curve *curve, double x, double measured, double expected, double tolerance);

// "at least ", "above " and so on, or "": what the curve's rule makes of a verdict's expected value.
const char *curve_bound(const Curve *curve);

// By the curve's rule.
CurveVerdict curve_judge(const Curve *curve);

// Exponent of the power law through the points, by least squares of the logarithms. NAN where there is none.
double curve_exponent(const Curve *curve);
