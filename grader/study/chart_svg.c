// Writes a script for gnuplot: families of settings as curves, bars of noise, and the front.
#include "study/chart_svg.h"

#include "scene/check.h"
#include "base/files.h"
#include "base/gnuplot.h"
#include "pages/curve_colors.h"
#include "study/verdict.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const int shapes[CURVE_COLORS] = {7, 5, 9, 11, 13, 6, 4, 8, 10, 12};

static bool same_family(const Finding *finding, const char *family, bool submission) {
    return finding->method.submission == submission && strcmp(finding->method.family, family) == 0;
}

int chart_family(const SceneFindings *findings, const char *family, bool submission) {
    int number = 0;
    for (int i = 0; i < findings->count; i++) {
        const Finding *finding = &findings->findings[i];
        if (same_family(finding, family, submission))
            return number;
        bool is_new = true;
        for (int j = 0; j < i; j++)
            is_new = is_new &&
                     !same_family(&findings->findings[j], finding->method.family, finding->method.submission);
        number += is_new;
    }
    return -1;
}

const char *chart_color(const SceneFindings *findings, const Method *method) {
    return method->submission ? curve_color_of_submission
                              : curve_colors[chart_family(findings, method->family, false) % CURVE_COLORS];
}

static void write_point(FILE *file, const SceneFindings *findings, int i) {
    const Point *point = &findings->points[i];
    fprintf(file, "%.6g %.6g %.6g %.6g\n", point->ms, fmax(point->error, CHART_LEAST_ERROR),
            fmax(point->ms - point->mad, point->ms / 2), point->ms + point->mad);
}

// Is this finding the first of its family?
static bool is_first(const SceneFindings *findings, int i) {
    const Method *method = &findings->findings[i].method;
    for (int j = 0; j < i; j++)
        if (same_family(&findings->findings[j], method->family, method->submission))
            return false;
    return true;
}

static void write_family(FILE *file, const SceneFindings *findings, const Method *method) {
    for (int i = 0; i < findings->count; i++)
        if (findings->findings[i].drawn &&
            same_family(&findings->findings[i], method->family, method->submission))
            write_point(file, findings, i);
    fputs("\n\n", file);
}

// The front from left to right: each point of it as gnuplot's `steps` want it.
static void write_front(FILE *file, const SceneFindings *findings) {
    double last = -1;
    for (int n = 0; n < findings->count; n++) {
        int next = -1;
        for (int i = 0; i < findings->count; i++)
            if (findings->points[i].on_front && !findings->findings[i].method.submission &&
                findings->points[i].ms > last &&
                (next < 0 || findings->points[i].ms < findings->points[next].ms))
                next = i;
        if (next < 0)
            break;
        last = findings->points[next].ms;
        write_point(file, findings, next);
    }
    fputs("\n\n", file);
}

// Blocks: the front, the chosen setting, then the families.
static bool write_data(const SceneFindings *findings, const char *path) {
    FILE *file = fopen(path, "w");
    if (!file)
        return check_fail("%s: %s", path, strerror(errno));
    write_front(file, findings);
    const Finding *chosen = findings_chosen(findings);
    if (chosen)
        write_point(file, findings, (int)(chosen - findings->findings));
    else
        fputs("-1 1 -1 -1\n", file); // nowhere
    fputs("\n\n", file);
    for (int i = 0; i < findings->count; i++)
        if (is_first(findings, i))
            write_family(file, findings, &findings->findings[i].method);
    return fclose(file) == 0 || check_fail("%s cannot be written", path);
}

// A little more than from the smallest to the largest error.
static void write_range(FILE *file, const SceneFindings *findings) {
    double low = 1, high = CHART_LEAST_ERROR;
    for (int i = 0; i < findings->count; i++)
        if (findings->findings[i].drawn) {
            low = fmin(low, fmax(findings->points[i].error, CHART_LEAST_ERROR));
            high = fmax(high, findings->points[i].error);
        }
    fprintf(file, "set yrange [%g:%g]\n", low / 1.5, high * 1.5);
}

// What gnuplot puts between double quotes: no quote, no backslash.
static void write_quoted(FILE *file, const char *text) {
    for (; *text; text++)
        if (*text != '"' && *text != '\\')
            fputc(*text, file);
}

static void write_time_axis(FILE *file, const SceneFindings *findings) {
    fprintf(file, "set xlabel \"%s time of a frame, ms (median; bars: MAD). %s\\n",
            findings->on_gpu ? "GPU" : "CPU",
            findings->on_gpu ? "Another GPU may rank them otherwise." : "A GPU may rank them otherwise.");
    write_quoted(file, findings->renderer);
    fputs("\" noenhanced\n", file);
}

static void write_axes(FILE *file, const SceneFindings *findings) {
    fprintf(file,
            "set terminal svg size 920,560 font 'sans-serif,13' background 'white'\n"
            "set output '%s.svg'\n"
            "set title '%s'\n"
            "set logscale xy\n"
            "set ylabel 'error: false shadow + false light, mean over the picture'\n"
            "set xtics add (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, "
            "100, 150, 200, 300, 500, 700, 1000)\n"
            "set ytics ('100 %%%%' 1, '10 %%%%' 0.1, '1 %%%%' 0.01, '0.1 %%%%' 1e-3, '0.01 %%%%' 1e-4, "
            "'0.001 %%%%' "
            "1e-5, 'none' 1e-6)\n"
            "set autoscale xfix\nset offsets graph 0.03, graph 0.03, 0, 0\n"
            "set grid xtics ytics lc rgb '#dddddd' lt 1 lw 1\nset key outside right top reverse Left spacing "
            "1.2\n"
            "set bars 0.5\n",
            findings->scene->name, findings->scene->title);
    write_time_axis(file, findings);
}

static bool write_script(const SceneFindings *findings, const char *path) {
    FILE *file = fopen(path, "w");
    if (!file)
        return check_fail("%s: %s", path, strerror(errno));
    write_axes(file, findings);
    write_range(file, findings);
    const char *name = findings->scene->name;
    fprintf(file, "plot '%s.dat' index 0 using 1:2 with steps lc rgb '#999999' lw 2 title 'front', \\\n",
            name);
    fprintf(
        file,
        "  '' index 1 using 1:2 with points pt 6 ps 2.4 lw 2 lc rgb '#000000' title 'enough, and cheapest'");
    for (int i = 0; i < findings->count; i++) {
        const Method *method = &findings->findings[i].method;
        if (!is_first(findings, i))
            continue;
        int family = chart_family(findings, method->family, method->submission);
        fprintf(file,
                ", \\\n  '' index %d using 1:2:3:4 with xerrorbars pt %d ps 0.7 lc rgb '%s' title '%s%s'",
                family + 2, method->submission ? 2 : shapes[family % CURVE_COLORS],
                chart_color(findings, method), method->submission ? "submission: " : "", method->family);
    }
    fputc('\n', file);
    return fclose(file) == 0 || check_fail("%s cannot be written", path);
}

bool chart_draw(const SceneFindings *findings, const char *folder) {
    char path[FILES_PATH], file[64];
    snprintf(file, sizeof file, "%s.dat", findings->scene->name);
    files_join(path, folder, file);
    if (!write_data(findings, path))
        return false;
    snprintf(file, sizeof file, "%s.gp", findings->scene->name);
    files_join(path, folder, file);
    return write_script(findings, path) && gnuplot_run(folder, file);
}
