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

typedef struct LayoutPoint {
    bool drawn;
    double x, y;           // where its numbers say
    double mark_x, mark_y; // of its mark, moved aside where others would hide it
    char label[LABEL_TEXT];
    bool labelled; // false: there is no room
    LayoutBox text;
} LayoutPoint;

// Places those points whose `drawn` is set within `plot`; `size` of the labels' font, pixels. What is chosen
// is labelled first, then the front, then the others.
void layout_points(const SceneFindings *findings, const LayoutAxis *time, const LayoutAxis *error,
                   LayoutBox plot, double size, LayoutPoint points[METHOD_MOST]);
