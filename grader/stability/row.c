#include "row.h"

#include "check.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const Row *row_find(int number) {
    static const Row *const lists[] = {rows_bias,   rows_kernel, rows_contact, rows_frame,
                                       rows_motion, rows_planes, rows_closed,  rows_stencil,
                                       rows_fill,   rows_bake,   rows_screen,  rows_later};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
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

static uint8_t grey(float visibility) {
    return (uint8_t)(visibility * 255 + 0.5f);
}

// The three pixels of the strip for one of the ground.
static void paint(uint8_t *yours, uint8_t *truth, uint8_t *error, float measured, float expected,
                  bool counts) {
    static const float light[3] = {255, 208, 32}, shadow[3] = {48, 112, 255};
    float seen = isfinite(measured) ? measured : 0, off = seen - expected;
    memset(yours, grey(seen), 3);
    memset(truth, grey(expected), 3);
    for (int c = 0; c < 3; c++) {
        float color = off > 0 ? light[c] : shadow[c], base = 40 + 30 * expected;
        error[c] = (uint8_t)(counts ? base + fabsf(off) * (color - base) : 0);
    }
    yours[3] = truth[3] = error[3] = 255;
}

void findings_frame(Findings *findings, int slot, double badness, const Ground *ground,
                    const Measured *measured, const char *caption, ...) {
    RowFrame *frame = &findings->frames[slot];
    if (frame->strip.rgba && badness <= frame->badness)
        return;
    int width = ground->size.width, height = ground->size.height;
    image_destroy(&frame->strip);
    if (!image_create(&frame->strip, 3 * width, height))
        return; // a picture less: the verdict does not depend on it
    va_list arguments;
    va_start(arguments, caption);
    vsnprintf(frame->caption, sizeof frame->caption, caption, arguments);
    va_end(arguments);
    frame->badness = badness;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            size_t at = (size_t)y * (size_t)width + (size_t)x;
            uint8_t *row = frame->strip.rgba + image_at(&frame->strip, x, y);
            paint(row, row + 4 * width, row + 8 * width, measured->visibility[at], ground->visibility[at],
                  measured->mask[at]);
        }
}

void findings_destroy(Findings *findings) {
    for (int i = 0; i < ROW_FRAMES; i++)
        image_destroy(&findings->frames[i].strip);
    *findings = (Findings){0};
}

RowStatus row_judge(const Row *row, bool ran, const Findings *findings, CurveVerdict *worst,
                    const Curve **curve) {
    *worst = (CurveVerdict){.share = -1};
    *curve = NULL;
    for (int f = 0; f < findings->figure_count; f++)
        for (int c = 0; c < findings->figures[f].count; c++) {
            CurveVerdict verdict = curve_judge(&findings->figures[f].curves[c]);
            if (verdict.share > worst->share) {
                *worst = verdict;
                *curve = &findings->figures[f].curves[c];
            }
        }
    if (!row->run)
        return ROW_NOT_BUILT;
    return ran && *curve && worst->holds ? ROW_PASS : ROW_FAIL;
}

const char *row_status_name(RowStatus status) {
    static const char *const names[] = {"pass", "fail", "not-built"};
    return names[status];
}
