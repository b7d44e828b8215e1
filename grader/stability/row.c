// Lists the rows of all labs in order, keeps their figures and frames, and judges a row by its curves.
#include "stability/row.h"

#include "scene/check.h"
#include "stability/strip.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static int add_sorted(const Row *rows[ROW_MOST], int count, const Row *table) {
    for (; table->number; table++) {
        int at = count++;
        INVARIANT(count <= ROW_MOST);
        for (; at > 0 && rows[at - 1]->number > table->number; at--)
            rows[at] = rows[at - 1];
        INVARIANT(at == 0 || rows[at - 1]->number < table->number);
        rows[at] = table;
    }
    return count;
}

int row_list(const Row *rows[ROW_MOST]) {
    int count = 0;
    for (int i = 0; rows_tables[i]; i++)
        count = add_sorted(rows, count, rows_tables[i]);
    return count;
}

Figure *findings_figure(Findings *findings, const char *title, const char *x_label, const char *y_label) {
    INVARIANT(findings->figure_count < ROW_FIGURES);
    Figure *figure = &findings->figures[findings->figure_count++];
    *figure = (Figure){.title = title, .x_label = x_label, .y_label = y_label};
    return figure;
}

void findings_frame(Findings *findings, int slot, double badness, const TruthView *truth_view,
                    const Measured *measured, const char *caption, ...) {
    RowFrame *frame = &findings->frames[slot];
    char words[ROW_TEXT];
    Image strip = {0};
    va_list arguments;
    if (!strip_create(&strip, truth_view, measured))
        return; // a picture less: the verdict does not depend on it
    va_start(arguments, caption);
    vsnprintf(words, sizeof words, caption, arguments);
    va_end(arguments);
    reel_add(&findings->reel, &strip, words);
    if (frame->strip.rgba && badness <= frame->badness) {
        image_destroy(&strip);
        return;
    }
    image_destroy(&frame->strip);
    *frame = (RowFrame){.badness = badness, .strip = strip};
    memcpy(frame->caption, words, sizeof words);
}

void findings_destroy(Findings *findings) {
    for (int i = 0; i < ROW_FRAMES; i++)
        image_destroy(&findings->frames[i].strip);
    reel_destroy(&findings->reel);
    *findings = (Findings){0};
}

// A known failure that is nowhere expected to show says nothing.
static bool shows_nothing(const Curve *curve) {
    bool shows = curve->rule != CURVE_EQUAL || strncmp(curve->name, "failure", 7) != 0;
    for (int i = 0; i < curve->count; i++)
        shows = shows || fabs(curve->points[i].expected) > curve->points[i].tolerance;
    return !shows;
}

static void find_worst(RowResult *result) {
    result->worst.share = -1;
    for (int f = 0; f < result->findings.figure_count; f++)
        for (int c = 0; c < result->findings.figures[f].count; c++) {
            const Curve *curve = &result->findings.figures[f].curves[c];
            CurveVerdict verdict = curve_judge(curve);
            if (shows_nothing(curve))
                verdict = (CurveVerdict){.share = CURVE_HOPELESS, .tolerance = verdict.tolerance};
            if (verdict.share > result->worst.share) {
                result->worst = verdict;
                result->curve = curve;
            }
        }
}

void row_run(RowResult *result, const Row *row, LabSet *labs) {
    *result = (RowResult){.row = row, .status = ROW_NOT_BUILT};
    check_clear();
    if (!row->run)
        return;
    bool ran = row->run(labs, &result->findings);
    if (!ran)
        snprintf(result->message, sizeof result->message, "%s", check_message());
    result->objects = lab_set_most_objects(labs);
    find_worst(result);
    result->status = ran && result->curve && result->worst.holds ? ROW_PASS : ROW_FAIL;
}

const char *row_status_name(RowStatus status) {
    static const char *const names[] = {"pass", "fail", "not-built"};
    return names[status];
}
