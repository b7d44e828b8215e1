#include "stability/curve.h"

#include "scene/check.h"

#include <math.h>

Curve *figure_curve(Figure *figure, const char *name, CurveRule rule) {
    INVARIANT(figure->count < FIGURE_CURVES);
    Curve *curve = &figure->curves[figure->count++];
    *curve = (Curve){.name = name, .rule = rule};
    return curve;
}

void curve_add(Curve *curve, double x, double measured, double expected, double tolerance) {
    INVARIANT(curve->count < CURVE_POINTS);
    curve->points[curve->count++] = (CurvePoint){x, measured, expected, tolerance};
}

double curve_exponent(const Curve *curve) {
    double n = curve->count, x = 0, y = 0, xx = 0, xy = 0;
    for (int i = 0; i < curve->count; i++) {
        double u = log(curve->points[i].x), v = log(curve->points[i].measured);
        x += u / n, y += v / n, xx += u * u / n, xy += u * v / n;
    }
    return (xy - x * y) / (xx - x * x);
}

const char *curve_bound(const Curve *curve) {
    static const char *const words[] = {"", "at least ", "at most ", "", "above ", "below "};
    return words[curve->rule];
}

// How much of the tolerance an excess takes up.
static double share_of(double excess, double tolerance) {
    if (excess <= 0)
        return 0;
    return excess / tolerance < CURVE_HOPELESS ? excess / tolerance : CURVE_HOPELESS; // also for 0 and NAN
}

static CurveVerdict judge(double excess, double measured, double expected, double tolerance) {
    double share = isfinite(measured) && isfinite(expected) ? share_of(excess, tolerance) : CURVE_HOPELESS;
    return (CurveVerdict){share <= 1, measured, expected, tolerance, share};
}

static CurveVerdict judge_level(CurveRule rule, const CurvePoint *point) {
    double above = point->measured - point->expected;
    double excess = rule == CURVE_LEAST ? -above : rule == CURVE_MOST ? above : fabs(above);
    return judge(excess, point->measured, point->expected, point->tolerance);
}

// From one point to the next, and (i = 0) from the first to the last, of a curve that rises.
static CurveVerdict judge_step(const Curve *curve, double sign, int i) {
    const CurvePoint *to = &curve->points[i ? i : curve->count - 1], *from = &curve->points[i ? i - 1 : 0];
    double rise = sign * (to->measured - from->measured);
    if (i)
        return judge(-rise, to->measured, from->measured, to->tolerance);
    bool rises = rise > to->tolerance && isfinite(rise);
    return (CurveVerdict){rises, to->measured, from->measured, to->tolerance, rises ? 0 : CURVE_HOPELESS};
}

static CurveVerdict judge_point(const Curve *curve, int i) {
    if (curve->rule == CURVE_RISING || curve->rule == CURVE_FALLING)
        return judge_step(curve, curve->rule == CURVE_RISING ? 1 : -1, i);
    return judge_level(curve->rule, &curve->points[i]);
}

CurveVerdict curve_judge(const Curve *curve) {
    CurveVerdict worst = {.share = CURVE_HOPELESS};
    if (curve->count == 0)
        return worst;
    if (curve->rule == CURVE_SLOPE) {
        double exponent = curve_exponent(curve);
        return judge(fabs(exponent - curve->slope), exponent, curve->slope, curve->tolerance);
    }
    worst = judge_point(curve, 0);
    for (int i = 1; i < curve->count; i++) {
        CurveVerdict verdict = judge_point(curve, i);
        bool tells_more = verdict.share == worst.share && fabs(verdict.expected) > fabs(worst.expected);
        if (verdict.share > worst.share || tells_more)
            worst = verdict;
    }
    return worst;
}
