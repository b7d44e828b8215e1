#include "stability/row.h"

#include "scene/check.h"
#include "stability/strip.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const Row *row_find(int number) {
    static const Row *const lists[] = {
        rows_bias,       // 1 to 3
        rows_kernel,     // 4, 5
        rows_contact,    // 6 to 8
        rows_frame,      // 9 to 11
        rows_depth,      // 12
        rows_resolution, // 13, 14
        rows_filter,     // 15, 16
        rows_early_out,  // 17
        rows_motion,     // 18
        rows_planes,     // 19 to 22
        rows_closed,     // 23 to 25
        rows_stencil,    // 26
        rows_fill,       // 27
        rows_bake,       // 28
        rows_screen,     // 29
        rows_later,      // 30, 31
        NULL,
    };
    for (int i = 0; lists[i]; i++)
        for (const Row *row = lists[i]; row->number; row++)
            if (row->number == number)
                return row;
    return NULL;
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
    if (frame->strip.rgba && badness <= frame->badness)
        return;
    image_destroy(&frame->strip);
    if (!strip_create(&frame->strip, truth_view, measured))
        return; // a picture less: the verdict does not depend on it
    va_list arguments;
    va_start(arguments, caption);
    vsnprintf(frame->caption, sizeof frame->caption, caption, arguments);
    va_end(arguments);
    frame->badness = badness;
}

void findings_destroy(Findings *findings) {
    for (int i = 0; i < ROW_FRAMES; i++)
        image_destroy(&findings->frames[i].strip);
    *findings = (Findings){0};
}

static void find_worst(RowResult *result) {
    result->worst.share = -1;
    for (int f = 0; f < result->findings.figure_count; f++)
        for (int c = 0; c < result->findings.figures[f].count; c++) {
            const Curve *curve = &result->findings.figures[f].curves[c];
            CurveVerdict verdict = curve_judge(curve);
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
    find_worst(result);
    result->status = ran && result->curve && result->worst.holds ? ROW_PASS : ROW_FAIL;
}

const char *row_status_name(RowStatus status) {
    static const char *const names[] = {"pass", "fail", "not-built"};
    return names[status];
}
