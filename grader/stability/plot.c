// Writes a row's figures as a script with its data for gnuplot, runs it, and so makes stability-NN.svg.
#include "stability/plot.h"

#include "scene/check.h"
#include "base/files.h"
#include "base/gnuplot.h"
#include "pages/curve_colors.h"

#include <math.h>
#include <stdio.h>

// A figure is readable when a phone shows it 345 pixels wide.
enum { WIDTH = 560, HEIGHT = 370, KEY_HEIGHT = 22, LETTERS = 15 };

static void write_quoted(FILE *out, const char *text) {
    fputc('\'', out);
    for (; *text; text++)
        fprintf(out, *text == '\'' ? "''" : "%c", *text);
    fputc('\'', out);
}

static bool has_level(const Curve *curve) {
    return curve->rule == CURVE_EQUAL || curve->rule == CURVE_LEAST || curve->rule == CURVE_MOST;
}

// The power law with the expected exponent through the middle of the points.
static double power_law(const Curve *curve, double x) {
    double u = 0, v = 0;
    for (int i = 0; i < curve->count; i++)
        u += log(curve->points[i].x) / curve->count, v += log(curve->points[i].measured) / curve->count;
    return exp(v + curve->slope * (log(x) - u));
}

// A block of data: x, measured, expected, and the tolerance's two ends.
static void write_data(FILE *out, const Figure *figure, int number, int c) {
    const Curve *curve = &figure->curves[c];
    fprintf(out, "$f%dc%d << EOD\n", number, c);
    for (int i = 0; i < curve->count; i++) {
        const CurvePoint *point = &curve->points[i];
        double expected = curve->rule == CURVE_SLOPE ? power_law(curve, point->x) : point->expected;
        double low = point->expected - point->tolerance;
        if (figure->log_y && low <= 0)
            low = point->expected / 10; // a logarithm has no room for the rest
        fprintf(out, "%.9g %.9g %.9g %.9g %.9g\n", point->x, point->measured, expected, low,
                point->expected + point->tolerance);
    }
    fputs("EOD\n", out);
}

static void write_title(FILE *out, const Curve *curve) {
    char text[ROW_TEXT];
    snprintf(text, sizeof text, "%s", curve->name);
    if (curve->rule == CURVE_SLOPE)
        check_append(text, sizeof text, " (dashed: slope %g)", curve->slope);
    if (curve->rule == CURVE_LEAST || curve->rule == CURVE_MOST)
        check_append(text, sizeof text, " (%sthe dashed)", curve_bound(curve));
    write_quoted(out, text);
}

static void write_curve(FILE *out, const Curve *curve, int number, int c) {
    if (curve->rule == CURVE_EQUAL && curve->count > 1)
        fprintf(out, "$f%dc%d using 1:4:5 with filledcurves fc rgb '%s' fs transparent solid 0.15 notitle, ",
                number, c, curve_colors[c]);
    if (has_level(curve) || curve->rule == CURVE_SLOPE)
        fprintf(out, "$f%dc%d using 1:3 with lines lc rgb '%s' dt 2 lw 2 notitle, ", number, c,
                curve_colors[c]);
    fprintf(out, "$f%dc%d using 1:2 with linespoints lc rgb '%s' pt %d ps 0.7 lw 1.5 title ", number, c,
            curve_colors[c], 5 + 2 * (c % 4));
    write_title(out, curve);
    fputs(", ", out);
}

static void write_axis(FILE *out, char axis, const char *label, bool logarithmic) {
    fprintf(out, "%s logscale %c\nset %ctics enhanced\nset format %c '%s'\nset %clabel ",
            logarithmic ? "set" : "unset", axis, axis, axis, logarithmic ? "10^{%L}" : "%g", axis);
    write_quoted(out, label);
    fputs(" noenhanced\n", out);
}

static void write_figure(FILE *out, const Figure *figure, int number) {
    for (int c = 0; c < figure->count; c++)
        if (figure->curves[c].count)
            write_data(out, figure, number, c);
    write_axis(out, 'x', figure->x_label, figure->log_x);
    write_axis(out, 'y', figure->y_label, figure->log_y);
    fputs(figure->log_y ? "unset offsets\nset title "
                        : "set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05\nset title ",
          out);
    write_quoted(out, figure->title);
    fprintf(out, " noenhanced\nset bmargin %d\nplot ", 5 + figure->count); // the key lies below
    int points = 0;
    for (int c = 0; c < figure->count; c++) {
        if (figure->curves[c].count)
            write_curve(out, &figure->curves[c], number, c);
        points += figure->curves[c].count;
    }
    fputs(points ? "1/0 notitle\n" : "[0:1] [0:1] 2 notitle\n", out);
}

void plot_name(char name[PLOT_NAME], const Row *row) {
    snprintf(name, PLOT_NAME, "stability-%02d.svg", row->number);
}

void plot_figure_name(char name[PLOT_NAME], const Row *row, int figure) {
    snprintf(name, PLOT_NAME, "stability-%02d-%d.svg", row->number, figure + 1);
}

// Some of the row's figures, side by side in one file.
static void write_picture(FILE *out, const Findings *findings, const char *name, int first, int count) {
    int most = 0;
    for (int i = first; i < first + count; i++)
        most = findings->figures[i].count > most ? findings->figures[i].count : most;
    fprintf(out, "set terminal svg size %d,%d enhanced font 'sans-serif,%d' background '#ffffff'\n",
            WIDTH * count, HEIGHT + KEY_HEIGHT * most, LETTERS);
    fprintf(out,
            "set output '%s'\nset grid lc rgb '#dddddd'\nset key below maxcols 1 noenhanced\nset multiplot "
            "layout 1,%d\n",
            name, count);
    for (int i = first; i < first + count; i++)
        write_figure(out, &findings->figures[i], i);
    fputs("unset multiplot\nunset output\n", out);
}

// All in one file, and each alone, for pages that are too narrow for all.
static void write_row(FILE *out, const RowResult *result) {
    const Findings *findings = &result->findings;
    char name[PLOT_NAME];
    plot_name(name, result->row);
    write_picture(out, findings, name, 0, findings->figure_count);
    for (int i = 0; i < findings->figure_count; i++) {
        plot_figure_name(name, result->row, i);
        write_picture(out, findings, name, i, 1);
    }
}

bool plot_all(const RowResult *results, int count, const char *folder) {
    char path[FILES_PATH];
    files_join(path, folder, "stability.gp");
    FILE *out = fopen(path, "w");
    if (!out)
        return check_fail("%s cannot be written", path);
    for (int i = 0; i < count; i++)
        if (results[i].findings.figure_count)
            write_row(out, &results[i]);
    return (fclose(out) == 0 || check_fail("%s cannot be written", path)) &&
           gnuplot_run(folder, "stability.gp");
}
