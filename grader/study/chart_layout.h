// Where the points of a chart and their labels stand: no mark hides another one, no label another label or a
// mark.
#pragma once

#include "study/chart_label.h"

// Errors below this are drawn at it: one wrong pixel of 640 x 480 is more.
#define LAYOUT_LEAST_ERROR 1e-6

enum { LAYOUT_MARK = 5 }; // radius of a mark, pixels

typedef struct LayoutBox {
    double left, top, right, bottom; // pixels, down is more
} LayoutBox;

// A logarithmic axis from `low` at pixel `from` to `high` at pixel `to`.
typedef struct LayoutAxis {
    double low, high, from, to;
} LayoutAxis;

// The pixel of a value > 0.
double layout_place(const LayoutAxis *axis, double value);

// Writes the numbers 1, 2 and 5 times a power of ten within the axis, where these are many 1 times, at most
// `most`; returns their number.
int layout_ticks(const LayoutAxis *axis, double *ticks, int most);

typedef struct LayoutPoint {
    bool drawn;
    double x, y;           // where its numbers say
    double mark_x, mark_y; // of its mark, moved aside where others would hide it
    char label[LABEL_TEXT];
    bool labelled; // false: there is no room
    LayoutBox text;
} LayoutPoint;

// The name of a line across the plot at `y`.
typedef struct LayoutName {
    const char *text;
    double y;
    LayoutBox box; // where it stands: above its line or below it
} LayoutName;

// Places the marks of those points whose `drawn` is set within `plot`.
void layout_marks(const SceneFindings *findings, const LayoutAxis *time, const LayoutAxis *error,
                  LayoutBox plot, LayoutPoint points[METHOD_MOST]);

// Then the names of lines, each as far to the right as no mark and no other name is in its way; `size` of the
// font, pixels.
void layout_names(const LayoutPoint *points, int point_count, LayoutBox plot, double size, LayoutName *names,
                  int count);

// Then the points' labels, away from all these. What is chosen is labelled first, then the front, then the
// others. The frame without shadows has none: its lines name it.
void layout_labels(const SceneFindings *findings, LayoutBox plot, double size, const LayoutName *names,
                   int name_count, LayoutPoint points[METHOD_MOST]);
