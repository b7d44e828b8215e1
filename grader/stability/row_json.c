#include "row_json.h"

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

void row_frame_name(char name[64], const Row *row, int slot) {
    snprintf(name, 64, "stability-%02d-%d.png", row->number, slot);
}

static json_t *frames_json(const Row *row, const Findings *findings) {
    json_t *frames = json_array();
    char name[64];
    for (int i = 0; i < ROW_FRAMES; i++)
        if (findings->frames[i].strip.rgba) {
            row_frame_name(name, row, i);
            json_array_append_new(
                frames, json_pack("{s:s, s:s}", "caption", findings->frames[i].caption, "file", name));
        }
    return frames;
}

json_t *row_json(const Row *row, const Findings *findings, const char *message) {
    CurveVerdict worst;
    const Curve *curve;
    RowStatus status = row_judge(row, !message, findings, &worst, &curve);
    json_t *figures = json_array();
    char figure[64];
    snprintf(figure, sizeof figure, "stability-%02d.svg", row->number);
    for (int i = 0; i < findings->figure_count; i++)
        json_array_append_new(figures, figure_json(&findings->figures[i]));
    return json_pack("{s:i, s:s, s:s, s:s, s:s, s:s, s:s, s:s?, s:s?, s:o, s:o, s:s?, s:o, s:o}", "id",
                     row->number, "name", row->name, "method", row->method, "status", row_status_name(status),
                     "sweep", row->sweep, "why", row->expected, "source", row->source, "message", message,
                     "curve", curve ? curve->name : NULL, "measured",
                     curve ? number(worst.measured) : json_null(), "expected",
                     curve ? number(worst.expected) : json_null(), "figure", curve ? figure : NULL, "figures",
                     figures, "frames", frames_json(row, findings));
}
