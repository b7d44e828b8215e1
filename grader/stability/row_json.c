#include "stability/row_json.h"

#include "stability/plot.h"

#include <math.h>
#include <stdio.h>

static json_t *number(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *curve_json(const Curve *curve) {
    static const char *const rules[] = {"equal", "least", "most", "slope", "rising", "falling"};
    CurveVerdict verdict = curve_judge(curve);
    json_t *points = json_array();
    for (int i = 0; i < curve->count; i++) {
        const CurvePoint *point = &curve->points[i];
        json_array_append_new(points, json_pack("[o, o, o, o]", number(point->x), number(point->measured),
                                                number(point->expected), number(point->tolerance)));
    }
    json_t *json = json_pack("{s:s, s:s, s:b, s:f, s:o}", "name", curve->name, "rule", rules[curve->rule],
                             "holds", verdict.holds, "share", verdict.share, "points", points);
    if (curve->rule == CURVE_SLOPE) {
        json_object_set_new(json, "slope", number(verdict.measured));
        json_object_set_new(json, "expected_slope", json_real(curve->slope));
        json_object_set_new(json, "tolerance", json_real(curve->tolerance));
    }
    return json;
}

static json_t *figure_json(const Figure *figure) {
    json_t *curves = json_array();
    for (int i = 0; i < figure->count; i++)
        json_array_append_new(curves, curve_json(&figure->curves[i]));
    return json_pack("{s:s, s:s, s:s, s:b, s:b, s:o}", "title", figure->title, "x", figure->x_label, "y",
                     figure->y_label, "log_x", figure->log_x, "log_y", figure->log_y, "curves", curves);
}

static json_t *frames_json(const Findings *findings) {
    json_t *frames = json_array();
    for (int i = 0; i < ROW_FRAMES; i++)
        if (findings->frames[i].strip.rgba)
            json_array_append_new(frames, json_string(findings->frames[i].caption));
    return frames;
}

json_t *row_json(const RowResult *result) {
    const Row *row = result->row;
    const Findings *findings = &result->findings;
    json_t *figures = json_array();
    char figure[PLOT_NAME];
    plot_name(figure, row);
    for (int i = 0; i < findings->figure_count; i++)
        json_array_append_new(figures, figure_json(&findings->figures[i]));
    return json_pack(
        "{s:i, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:i, s:s?, s:o, s:o, s:s?, s:o, s:o}", "id", row->number,
        "name", row->name, "method", row->method, "status", row_status_name(result->status), "sweep",
        row->sweep, "why", row->expected, "source", row->source, "message", result->message, "objects",
        result->objects, "curve", result->curve ? result->curve->name : NULL, "measured",
        result->curve ? number(result->worst.measured) : json_null(), "expected",
        result->curve ? number(result->worst.expected) : json_null(), "figure",
        findings->figure_count ? figure : NULL, "figures", figures, "frames", frames_json(findings));
}
