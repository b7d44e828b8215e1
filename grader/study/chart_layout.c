// Puts marks and labels side by side: ring by ring and side by side until one is free.
#include "study/chart_layout.h"

#include <math.h>
#include <string.h>

double layout_place(const LayoutAxis *axis, double value) {
    return axis->from + log(value / axis->low) / log(axis->high / axis->low) * (axis->to - axis->from);
}

static bool overlap(LayoutBox a, LayoutBox b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

static LayoutBox mark_box(double x, double y) {
    return (LayoutBox){x - LAYOUT_MARK, y - LAYOUT_MARK, x + LAYOUT_MARK, y + LAYOUT_MARK};
}

static bool is_within(LayoutBox inner, LayoutBox outer) {
    return inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top &&
           inner.bottom <= outer.bottom;
}

// Is the place free of all marks before point `i`?
static bool is_free(const LayoutPoint *points, int i, double x, double y) {
    for (int j = 0; j < i; j++)
        if (points[j].drawn && overlap(mark_box(x, y), mark_box(points[j].mark_x, points[j].mark_y)))
            return false;
    return true;
}

// Ring by ring around its place.
static void place_mark(LayoutPoint *points, int i, LayoutBox plot) {
    enum { RINGS = 24, DIRECTIONS = 12 };
    LayoutPoint *point = &points[i];
    point->mark_x = point->x;
    point->mark_y = point->y;
    for (int ring = 0; ring < RINGS; ring++)
        for (int d = 0; d < (ring ? DIRECTIONS : 1); d++) {
            double angle = 2 * M_PI * d / DIRECTIONS, away = ring * LAYOUT_MARK;
            double x = point->x + away * cos(angle), y = point->y + away * sin(angle);
            if (!is_free(points, i, x, y) || (ring > 0 && !is_within(mark_box(x, y), plot)))
                continue;
            point->mark_x = x;
            point->mark_y = y;
            return;
        }
}

static bool label_fits(const LayoutPoint *points, int count, int i, LayoutBox plot) {
    LayoutBox text = points[i].text;
    bool fits = is_within(text, plot);
    for (int j = 0; fits && j < count; j++)
        fits = !points[j].drawn || (!overlap(text, mark_box(points[j].mark_x, points[j].mark_y)) &&
                                    !(points[j].labelled && overlap(text, points[j].text)));
    return fits;
}

static void place_label(LayoutPoint *points, int count, int i, double size, LayoutBox plot) {
    static const double sides[][2] = {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    LayoutPoint *point = &points[i];
    double width = 0.58 * size * (double)strlen(point->label), height = 0.9 * size, gap = LAYOUT_MARK + 1;
    for (int s = 0; s < 8; s++) {
        double x = point->mark_x + sides[s][0] * (gap + width / 2),
               y = point->mark_y + sides[s][1] * (gap + height / 2);
        point->text = (LayoutBox){x - width / 2, y - height / 2, x + width / 2, y + height / 2};
        point->labelled = label_fits(points, count, i, plot);
        if (point->labelled)
            return;
    }
}

static int rank(const SceneFindings *findings, int i) {
    return findings->findings[i].chosen ? 0 : findings->points[i].on_front ? 1 : 2;
}

void layout_points(const SceneFindings *findings, const LayoutAxis *time, const LayoutAxis *error,
                   LayoutBox plot, double size, LayoutPoint points[METHOD_MOST]) {
    for (int i = 0; i < findings->count; i++) {
        const Point *point = &findings->points[i];
        points[i] = (LayoutPoint){.drawn = points[i].drawn};
        if (!points[i].drawn)
            continue;
        points[i].x = layout_place(time, point->ms);
        points[i].y = layout_place(error, fmax(point->error, LAYOUT_LEAST_ERROR));
        label_write(findings->findings[i].method.name, points[i].label);
        place_mark(points, i, plot);
    }
    for (int wanted = 0; wanted <= 2; wanted++)
        for (int i = 0; i < findings->count; i++)
            if (points[i].drawn && rank(findings, i) == wanted)
                place_label(points, findings->count, i, size, plot);
}
