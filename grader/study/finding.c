// Sums a finding up: its times over frames, its errors over views.
#include "study/finding.h"

#include "scene/check.h"
#include "base/statistics.h"

#include <math.h>
#include <stdlib.h>

double finding_interior_error(const MeasuredErrors *errors) {
    return errors->interior_false_shadow + errors->interior_false_light;
}

double finding_error(const MeasuredErrors *errors) {
    return errors->edge_false_shadow + errors->edge_false_light + finding_interior_error(errors);
}

static double total(const MeasuredTime *time) {
    return time->prepare + time->shade;
}
static double prepare(const MeasuredTime *time) {
    return time->prepare;
}
static double shade(const MeasuredTime *time) {
    return time->shade;
}

static void summarise(const MeasuredTime *times, int count, double (*part)(const MeasuredTime *),
                      double *median, double *mad) {
    double *values = calloc((size_t)count, sizeof *values);
    INVARIANT(values);
    for (int i = 0; i < count; i++)
        values[i] = part(&times[i]);
    *median = statistics_median(values, (size_t)count);
    *mad = statistics_mad(values, (size_t)count);
    free(values);
}

void finding_time(Finding *finding, Point *point, const MeasuredTime *times, int count) {
    finding->frames = count;
    summarise(times, count, total, &point->ms, &point->mad);
    summarise(times, count, prepare, &finding->prepare_ms, &finding->prepare_mad);
    summarise(times, count, shade, &finding->shade_ms, &finding->shade_mad);
}

void finding_errors(Finding *finding) {
    finding->errors = (MeasuredErrors){0};
    finding->worst_inside = finding->worst_off = 0;
    for (int v = 0; v < STUDY_VIEWS; v++) {
        const MeasuredErrors *view = &finding->views[v];
        measured_errors_add(&finding->errors, view, 1.0 / STUDY_VIEWS);
        finding->worst_inside = fmax(finding->worst_inside, finding_interior_error(view));
        finding->worst_off = fmax(finding->worst_off, view->off);
    }
}

void finding_range(const Finding *finding, double *low, double *high) {
    *low = *high = finding_error(&finding->views[0]);
    for (int v = 1; v < STUDY_VIEWS; v++) {
        double error = finding_error(&finding->views[v]);
        *low = fmin(*low, error);
        *high = fmax(*high, error);
    }
}
