// Draws axes, curves, bars, marks, labels and a legend as SVG: 480 pixels wide, so that letters stay large
// enough where it is shown on 360.
#include "study/chart_svg.h"

#include "base/files.h"
#include "scene/check.h"
#include "study/chart_layout.h"
#include "study/svg.h"
#include "study/verdict.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 480, PLOT_HEIGHT = 470, ROW = 19, LETTERS = 14, SMALL = 12 };
static const LayoutBox plot = {70, 48, WIDTH - 10, 48 + PLOT_HEIGHT};

// What goes to the right.
static const struct {
    const char *file, *of_cpu, *of_gpu, *unit, *bars;
} axes[] = {
    [CHART_TIME] = {"", "CPU time of a frame, ms", "GPU time of a frame, ms", " ms",
                    "MAD of the times, and "},
    [CHART_COST] = {"-cost", "counted: reads, fragments, texels a pixel",
                    "counted: reads, fragments, texels a pixel", " a pixel", ""},
};

typedef struct ChartPicture {
    const SceneFindings *findings;
    ChartAxis axis;
    LayoutAxis time, error;
    double slowest; // of all but ray tracing, ms
    LayoutPoint points[METHOD_MOST];
    LayoutName names[BASELINES_MOST]; // of lines
    int name_count;
    Svg svg;
} ChartPicture;

static void grow(LayoutAxis *axis, double value) {
    axis->low = fmin(axis->low, value);
    axis->high = fmax(axis->high, value);
}

enum { BEYOND = 3 }; // rays may take so many times as long as the slowest of the others

static double slowest(const SceneFindings *findings) {
    double most = 0;
    for (int i = 0; i < findings->count; i++)
        if (findings->findings[i].drawn && findings->findings[i].method.rays == 0)
            most = fmax(most, findings->points[i].ms);
    return most;
}

// Has the setting a point? Rays that take far longer than all labs would push these together; they are told
// below.
static bool is_charted(const ChartPicture *chart, int i) {
    const Finding *finding = &chart->findings->findings[i];
    return finding->drawn &&
           (finding->method.rays == 0 || chart->findings->points[i].ms <= BEYOND * chart->slowest);
}

static void set_axes(ChartPicture *chart) {
    const SceneFindings *findings = chart->findings;
    chart->slowest = slowest(findings);
    chart->time = (LayoutAxis){INFINITY, 0, plot.left, plot.right};
    chart->error = (LayoutAxis){INFINITY, 0, plot.bottom, plot.top};
    for (int i = 0; i < findings->count; i++)
        if (is_charted(chart, i)) {
            grow(&chart->time, findings->points[i].ms);
            grow(&chart->error, fmax(findings->points[i].error, LAYOUT_LEAST_ERROR));
        }
    const Baseline *floor = baselines_floor(&findings->lines);
    if (floor)
        grow(&chart->error, fmax(finding_error(&floor->errors), LAYOUT_LEAST_ERROR));
    chart->time.low /= 1.25, chart->time.high *= 1.4;
    chart->error.low /= 1.5, chart->error.high *= 1.6;
}

static void draw_axes(ChartPicture *chart) {
    double ticks[32];
    Svg *svg = &chart->svg;
    for (int i = 0, count = layout_ticks(&chart->time, ticks, 32); i < count; i++) {
        double x = layout_place(&chart->time, ticks[i]);
        svg_line(svg, x, plot.top, x, plot.bottom, "#dddddd", 1, NULL);
        svg_text(svg, x, plot.bottom + 17, LETTERS, "middle", "#1a1a1a", "%g", ticks[i]);
    }
    for (int i = 0, count = layout_ticks(&chart->error, ticks, 32); i < count; i++) {
        double y = layout_place(&chart->error, ticks[i]);
        svg_line(svg, plot.left, y, plot.right, y, "#dddddd", 1, NULL);
        svg_text(svg, plot.left - 5, y + 5, LETTERS, "end", "#1a1a1a", "%g %%", 100 * ticks[i]);
    }
    svg_box(svg, plot, "#555555");
    svg_text(svg, WIDTH / 2.0, 19, LETTERS + 1, "middle", "#1a1a1a", "%s", chart->findings->scene->title);
    svg_text(svg, 10, plot.top - 8, LETTERS, "start", "#1a1a1a", "error, mean over the picture");
    svg_text(svg, plot.right, plot.bottom + 35, LETTERS, "end", "#1a1a1a", "%s",
             chart->findings->on_gpu ? axes[chart->axis].of_gpu : axes[chart->axis].of_cpu);
}

// Lines that lie outside are named in the legend.
static bool is_inside(const ChartPicture *chart, double error) {
    return error >= chart->error.low && error <= chart->error.high;
}

static double line_error(const Baseline *line) {
    return fmax(finding_error(&line->errors), LAYOUT_LEAST_ERROR);
}

static void list_names(ChartPicture *chart) {
    for (int i = 0; i < chart->findings->lines.count; i++) {
        const Baseline *line = &chart->findings->lines.lines[i];
        if (is_inside(chart, line_error(line)))
            chart->names[chart->name_count++] =
                (LayoutName){.text = line->name, .y = layout_place(&chart->error, line_error(line))};
    }
}

// Over the curves, so that none crosses a name.
static void draw_baselines(ChartPicture *chart) {
    const char *floor = chart->name_count > 0 ? baselines_floor(&chart->findings->lines)->name : "";
    for (int i = 0; i < chart->name_count; i++) {
        const LayoutName *name = &chart->names[i];
        svg_line(&chart->svg, plot.left, name->y, plot.right, name->y, "#555555", 1.2,
                 name->text == floor ? "2 3" : "7 4");
        svg_text(&chart->svg, (name->box.left + name->box.right) / 2, name->box.bottom - 1, SMALL, "middle",
                 "#555555", "%s", name->text);
    }
}

static void draw_front(ChartPicture *chart) {
    const SceneFindings *findings = chart->findings;
    double last = -1, x = 0, y = 0;
    for (;;) {
        int next = -1;
        for (int i = 0; i < findings->count; i++)
            if (findings->points[i].on_front && !findings->findings[i].method.submission &&
                findings->points[i].ms > last &&
                (next < 0 || findings->points[i].ms < findings->points[next].ms))
                next = i;
        if (next < 0)
            return;
        double to_x = chart->points[next].x, to_y = chart->points[next].y;
        if (last >= 0) {
            svg_line(&chart->svg, x, y, to_x, y, "#bbbbbb", 5, NULL);
            svg_line(&chart->svg, to_x, y, to_x, to_y, "#bbbbbb", 5, NULL);
        }
        x = to_x, y = to_y, last = findings->points[next].ms;
    }
}

// A line where the frame without shadows lies: what a method takes beyond it is the price of its shadow.
static void draw_bare(ChartPicture *chart) {
    const LayoutPoint *at = chart->points;
    for (int i = 0; i < chart->findings->count; i++)
        if (at[i].drawn && strcmp(chart->findings->findings[i].method.family, METHOD_BARE) == 0)
            svg_line(&chart->svg, at[i].x, plot.top, at[i].x, plot.bottom, "#777777", 1.2, "1 3");
}

// The curve to a point, its bars, and, where its mark stands aside, the way there.
static void draw_strokes(ChartPicture *chart, int i) {
    const LayoutPoint *at = &chart->points[i];
    const Point *point = &chart->findings->points[i];
    const char *color = label_color(chart->findings, &chart->findings->findings[i].method);
    int before = label_before(chart->findings, i);
    double low, high;
    finding_range(&chart->findings->findings[i], &low, &high);
    if (before >= 0 && chart->points[before].drawn)
        svg_line(&chart->svg, chart->points[before].x, chart->points[before].y, at->x, at->y, color, 1.4,
                 NULL);
    svg_line(&chart->svg, layout_place(&chart->time, fmax(point->ms - point->mad, point->ms / 2)), at->y,
             layout_place(&chart->time, point->ms + point->mad), at->y, color, 1, NULL);
    svg_line(&chart->svg, at->x, layout_place(&chart->error, fmax(low, LAYOUT_LEAST_ERROR)), at->x,
             layout_place(&chart->error, fmax(high, LAYOUT_LEAST_ERROR)), color, 1, NULL);
    if (at->mark_x != at->x || at->mark_y != at->y)
        svg_line(&chart->svg, at->x, at->y, at->mark_x, at->mark_y, "#777777", 0.8, "2 1");
}

static void draw_mark(ChartPicture *chart, int i) {
    const Finding *finding = &chart->findings->findings[i];
    const LayoutPoint *at = &chart->points[i];
    int family = label_family(chart->findings, finding->method.family, finding->method.submission);
    svg_begin_titled(&chart->svg, "%s%s, %s: %.3g%s, error %.3g %%",
                     finding->method.submission ? "submission: " : "", finding->method.family,
                     finding->method.name, chart->findings->points[i].ms, axes[chart->axis].unit,
                     100 * chart->findings->points[i].error);
    if (finding->chosen)
        svg_ring(&chart->svg, at->mark_x, at->mark_y, 2 * LAYOUT_MARK, "#000000");
    svg_mark(&chart->svg, at->mark_x, at->mark_y, LAYOUT_MARK,
             finding->method.submission ? SVG_CROSS : family, label_color(chart->findings, &finding->method));
    if (at->labelled)
        svg_text(&chart->svg, (at->text.left + at->text.right) / 2, at->text.bottom - 1, SMALL, "middle",
                 "#1a1a1a", "%s", at->label);
    svg_end_titled(&chart->svg);
}

static bool is_first(const SceneFindings *findings, int i) {
    for (int j = 0; j < i; j++)
        if (label_same_family(&findings->findings[j], &findings->findings[i]))
            return false;
    return true;
}

// Two columns below the plot, from the line `y` on; the next free line.
static double draw_families(ChartPicture *chart, double y) {
    int place = 0;
    for (int i = 0; i < chart->findings->count; i++) {
        const Method *method = &chart->findings->findings[i].method;
        if (!is_first(chart->findings, i))
            continue;
        double x = 16 + place % 2 * (WIDTH / 2.0), line = y + ROW * (place / 2); // NOLINT
        int family = label_family(chart->findings, method->family, method->submission);
        svg_mark(&chart->svg, x, line - 4, LAYOUT_MARK, method->submission ? SVG_CROSS : family,
                 label_color(chart->findings, method));
        svg_text(&chart->svg, x + 11, line, SMALL + 1, "start", "#1a1a1a", "%s%s",
                 method->submission ? "submission: " : "", method->family);
        place++;
    }
    return y + ROW * ((place + 1) / 2); // NOLINT
}

// An example of a short name: that of what is chosen, or of the first.
static const Finding *example(const SceneFindings *findings) {
    const Finding *chosen = findings_chosen(findings);
    return chosen ? chosen : &findings->findings[0];
}

static void note(ChartPicture *chart, double *y, const char *text) {
    svg_text(&chart->svg, 10, *y, SMALL, "start", "#444444", "%s", text);
    *y += ROW - 3;
}

static double draw_notes(ChartPicture *chart, double y) {
    char text[200], label[LABEL_TEXT];
    label_write(example(chart->findings)->method.name, label);
    snprintf(text, sizeof text, "%s = %s.", label, example(chart->findings)->method.name);
    note(chart, &y, text);
    note(chart, &y, "Ring: the cheapest that is enough. Grey: the front.");
    snprintf(text, sizeof text, "Bars: %sleast and most error of %d views.", axes[chart->axis].bars,
             STUDY_VIEWS);
    note(chart, &y, text);
    for (int i = 0; i < chart->findings->lines.count; i++) {
        const Baseline *line = &chart->findings->lines.lines[i];
        if (is_inside(chart, line_error(line)))
            continue;
        snprintf(text, sizeof text, "Outside: %s, %.3g %%.", line->name, 100 * finding_error(&line->errors));
        note(chart, &y, text);
    }
    for (int i = 0; i < chart->findings->count; i++) {
        const Finding *finding = &chart->findings->findings[i];
        if (!finding->drawn || is_charted(chart, i))
            continue;
        snprintf(text, sizeof text, "Outside: %s, %s: %.0f ms, %.2g %%.", finding->method.family,
                 finding->method.name, chart->findings->points[i].ms, 100 * chart->findings->points[i].error);
        note(chart, &y, text);
    }
    note(chart, &y, chart->findings->renderer);
    return y;
}

static void draw(ChartPicture *chart) {
    const SceneFindings *findings = chart->findings;
    for (int i = 0; i < findings->count; i++)
        chart->points[i].drawn = is_charted(chart, i);
    layout_marks(findings, &chart->time, &chart->error, plot, chart->points);
    list_names(chart);
    layout_names(chart->points, findings->count, plot, SMALL, chart->names, chart->name_count);
    layout_labels(findings, plot, SMALL, chart->names, chart->name_count, chart->points);
    draw_axes(chart);
    draw_front(chart);
    draw_bare(chart);
    for (int i = 0; i < findings->count; i++)
        if (chart->points[i].drawn)
            draw_strokes(chart, i);
    draw_baselines(chart);
    for (int i = 0; i < findings->count; i++)
        if (chart->points[i].drawn)
            draw_mark(chart, i);
    double y = draw_notes(chart, draw_families(chart, plot.bottom + 62) + 4);
    svg_end(&chart->svg, WIDTH, (int)y);
}

bool chart_draw(const SceneFindings *findings, ChartAxis axis, const char *folder) {
    char path[FILES_PATH], file[64];
    ChartPicture *chart = calloc(1, sizeof *chart);
    if (!chart)
        return check_fail("out of memory for a chart");
    chart->findings = findings;
    chart->axis = axis;
    snprintf(file, sizeof file, "%s%s.svg", findings->scene->name, axes[axis].file);
    files_join(path, folder, file);
    set_axes(chart);
    bool ok = svg_begin(&chart->svg);
    if (ok)
        draw(chart);
    ok = ok && svg_write(&chart->svg, path);
    free(chart);
    return ok;
}
