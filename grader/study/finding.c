// Sums a finding up (times, errors), judges those of a scene against each other, and says in words what the
// scene needs.
#include "study/finding.h"

#include "scene/check.h"
#include "base/statistics.h"

#include <stdlib.h>
#include <string.h>

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

static bool is_enough(const Finding *finding, double tolerance) {
    return finding->drawn && finding_interior_error(&finding->errors) <= tolerance &&
           finding->errors.off <= FINDING_MOST_OFF;
}

void findings_judge(SceneFindings *findings) {
    Finding *cheapest = NULL;
    double least = 0;
    for (int i = 0; i < findings->count; i++) {
        Finding *finding = &findings->findings[i];
        Point *point = &findings->points[i];
        point->error = finding_error(&finding->errors);
        point->ms = finding->drawn ? point->ms : -1;
        finding->chosen = false;
        finding->enough = is_enough(finding, findings->scene->tolerance);
        if (finding->enough && !finding->method.submission && (!cheapest || point->ms < least)) {
            cheapest = finding;
            least = point->ms;
        }
    }
    if (cheapest)
        cheapest->chosen = true;
    pareto_mark(findings->points, (size_t)findings->count);
}

const Finding *findings_chosen(const SceneFindings *findings) {
    for (int i = 0; i < findings->count; i++)
        if (findings->findings[i].chosen)
            return &findings->findings[i];
    return NULL;
}

const Finding *findings_next_cheaper(const SceneFindings *findings) {
    const Finding *chosen = findings_chosen(findings);
    const Point *limit = chosen ? &findings->points[chosen - findings->findings] : NULL, *best = NULL;
    for (int i = 0; limit && i < findings->count; i++) {
        const Point *point = &findings->points[i];
        if (point->on_front && !findings->findings[i].method.submission && point->ms < limit->ms &&
            (!best || point->ms > best->ms))
            best = point;
    }
    return best ? &findings->findings[best - findings->points] : NULL;
}

static void tell_wrong(const Finding *finding, double tolerance, char *text, size_t size) {
    const MeasuredErrors *errors = &finding->errors;
    double inside = finding_interior_error(errors);
    if (inside <= tolerance)
        check_append(text, size, "its edge is off by %.2g pixels", errors->off);
    else
        check_append(text, size, "%.2g %% error inside, mostly false %s", 100 * inside,
                     errors->interior_false_shadow > errors->interior_false_light ? "shadow" : "light");
}

void findings_tell(const SceneFindings *findings, char *text, size_t size) {
    const Finding *chosen = findings_chosen(findings), *next = findings_next_cheaper(findings);
    text[0] = '\0';
    if (!chosen) {
        check_append(text, size, "none of these settings is enough");
        return;
    }
    check_append(text, size, "%s, %s (lab %s)", chosen->method.family, chosen->method.name,
                 chosen->method.lab);
    if (!next) {
        check_append(text, size, "; nothing is cheaper");
        return;
    }
    check_append(text, size, "; the next cheaper, %s, %s (lab %s): ", next->method.family, next->method.name,
                 next->method.lab);
    tell_wrong(next, findings->scene->tolerance, text, size);
}
