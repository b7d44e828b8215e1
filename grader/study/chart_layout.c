// Puts marks and labels side by side: ring by ring and side by side until one is free.
#include "study/chart_layout.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static const double LETTER = 0.58; // mean width of a letter, of the font's size

double layout_place(const LayoutAxis *axis, double value) {
    return axis->from + log(value / axis->low) / log(axis->high / axis->low) * (axis->to - axis->from);
}

int layout_ticks(const LayoutAxis *axis, double *ticks, int most) {
    static const double steps[] = {1, 2, 5};
    bool wide = axis->high > 300 * axis->low;
    int count = 0;
    for (int power = -9; power <= 6; power++)
        for (int s = 0; s < (wide ? 1 : 3); s++) {
            double tick = steps[s] * pow(10, power);
            if (tick >= axis->low && tick <= axis->high && count < most)
                ticks[count++] = tick;
        }
    return count;
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

static LayoutBox text_box(double x, double y, const char *text, double size) {
    double width = LETTER * size * (double)strlen(text), height = 0.9 * size;
    return (LayoutBox){x - width / 2, y - height / 2, x + width / 2, y + height / 2};
}

static int count_hidden(const LayoutPoint *points, int count, LayoutBox text) {
    int hidden = 0;
    for (int i = 0; i < count; i++)
        hidden += points[i].drawn && overlap(text, mark_box(points[i].mark_x, points[i].mark_y));
    return hidden;
}

static bool hides_name(const LayoutName *names, int count, LayoutBox text) {
    for (int i = 0; i < count; i++)
        if (overlap(text, names[i].box))
            return true;
    return false;
}

// From right to left, above its line and below it: the first place that hides the fewest marks.
static void place_name(const LayoutPoint *points, int point_count, LayoutBox plot, double size,
                       LayoutName *names, int i) {
    enum { STEPS = 16 };
    const double half = text_box(0, 0, names[i].text, size).right,
                 room = plot.right - plot.left - 8 - 2 * half;
    int least = INT_MAX;
    for (int step = 0; step < 2 * STEPS; step++) {
        LayoutBox box = text_box(plot.right - 4 - half - room * (step / 2) / (STEPS - 1), // NOLINT
                                 names[i].y + (step % 2 ? 0.75 : -0.75) * size, names[i].text, size);
        int hidden = count_hidden(points, point_count, box);
        if (step == 0)
            names[i].box = box;
        if (hidden < least && is_within(box, plot) && !hides_name(names, i, box)) {
            names[i].box = box;
            least = hidden;
        }
    }
}

void layout_names(const LayoutPoint *points, int point_count, LayoutBox plot, double size, LayoutName *names,
                  int count) {
    for (int i = 0; i < count; i++)
        place_name(points, point_count, plot, size, names, i);
}

// What is around the labels.
typedef struct Crowd {
    LayoutPoint *points;
    const LayoutName *names;
    int count, name_count;
    LayoutBox plot;
    double size;
} Crowd;

static bool label_fits(const Crowd *crowd, LayoutBox text) {
    bool fits = is_within(text, crowd->plot) && count_hidden(crowd->points, crowd->count, text) == 0 &&
                !hides_name(crowd->names, crowd->name_count, text);
    for (int j = 0; fits && j < crowd->count; j++)
        fits = !crowd->points[j].labelled || !overlap(text, crowd->points[j].text);
    return fits;
}

static void place_label(const Crowd *crowd, LayoutPoint *point) {
    static const double sides[][2] = {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}};
    const LayoutBox first = text_box(0, 0, point->label, crowd->size);
    const double gap = LAYOUT_MARK + 1;
    for (int s = 0; s < 8 && !point->labelled; s++) {
        LayoutBox text =
            text_box(point->mark_x + sides[s][0] * (gap + first.right),
                     point->mark_y + sides[s][1] * (gap + first.bottom), point->label, crowd->size);
        point->labelled = label_fits(crowd, text);
        point->text = text;
    }
}

static int rank(const SceneFindings *findings, int i) {
    return findings->findings[i].chosen ? 0 : findings->points[i].on_front ? 1 : 2;
}

void layout_marks(const SceneFindings *findings, const LayoutAxis *time, const LayoutAxis *error,
                  LayoutBox plot, LayoutPoint points[METHOD_MOST]) {
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
}

void layout_labels(const SceneFindings *findings, LayoutBox plot, double size, const LayoutName *names,
                   int name_count, LayoutPoint points[METHOD_MOST]) {
    const Crowd crowd = {points, names, findings->count, name_count, plot, size};
    for (int wanted = 0; wanted <= 2; wanted++)
        for (int i = 0; i < findings->count; i++)
            if (points[i].drawn && rank(findings, i) == wanted &&
                strcmp(findings->findings[i].method.family, METHOD_BARE) != 0)
                place_label(&crowd, &points[i]);
}
