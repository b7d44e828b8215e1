// Writes the suite's page: a summary, and for each row its words, verdict, curves, numbers and worst frames.
#include "stability/suite_html.h"

#include "base/files.h"
#include "stability/plot.h"
#include "pages/page.h"
#include "pages/template.h"
#include "scene/check.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SVG = 1 << 22 };

static const char *status_class(RowStatus status) {
    static const char *const classes[] = {"good", "bad", "quiet"};
    return classes[status];
}

static const char *status_words(RowStatus status) {
    static const char *const words[] = {"✓ pass", "✗ fail", "– not built"};
    return words[status];
}

static void write_cell(Page *page, const char *bound, double value) {
    fprintf(page->out, "<td class=\"number\">%s", isfinite(value) ? bound : "");
    if (isfinite(value))
        fprintf(page->out, "%.4g", value);
    else
        fputs("–", page->out);
    fputs("</td>", page->out);
}

static void write_element(Page *page, const char *name, const char *text) {
    fprintf(page->out, "<%s>", name);
    page_text(page, text);
    fprintf(page->out, "</%s>", name);
}

static void write_summary(Page *page, const RowResult *results, int count) {
    page_begin_table(page, "All rows",
                     (const char *const[]){"#row", "name", "method", "status", "its tightest curve",
                                           "#measured", "#expected", NULL});
    for (int i = 0; i < count; i++) {
        const RowResult *result = &results[i];
        fprintf(page->out, "<tr><td class=\"number\">%d</td><td><a href=\"#row-%d\">", result->row->number,
                result->row->number);
        page_text(page, result->row->name);
        fputs("</a></td>", page->out);
        page_cell(page, result->row->method);
        fprintf(page->out, "<td class=\"%s state\">%s</td>", status_class(result->status),
                status_words(result->status));
        page_cell(page, result->curve ? result->curve->name : "–");
        write_cell(page, "", result->curve ? result->worst.measured : NAN);
        write_cell(page, result->curve ? curve_bound(result->curve) : "",
                   result->curve ? result->worst.expected : NAN);
        fputs("</tr>\n", page->out);
    }
    page_end_table(page);
}

static void write_points(Page *page, const Curve *curve) {
    bool level = curve->rule <= CURVE_MOST;
    for (int i = 0; i < curve->count; i++) {
        const CurvePoint *point = &curve->points[i];
        fputs("<tr>", page->out);
        page_cell(page, curve->name);
        write_cell(page, "", point->x);
        write_cell(page, "", point->measured);
        write_cell(page, curve_bound(curve), level ? point->expected : NAN);
        write_cell(page, "", curve->rule == CURVE_SLOPE ? NAN : point->tolerance);
        fputs("</tr>\n", page->out);
    }
}

static void write_numbers(Page *page, const Figure *figure) {
    char x[ROW_TEXT], y[ROW_TEXT];
    snprintf(x, sizeof x, "#%s", figure->x_label);
    snprintf(y, sizeof y, "#%s", figure->y_label);
    fputs("<details><summary>The numbers: ", page->out);
    page_text(page, figure->title);
    fputs("</summary>", page->out);
    page_begin_table(page, "Numbers", (const char *const[]){"curve", x, y, "#expected", "#tolerance", NULL});
    for (int c = 0; c < figure->count; c++)
        write_points(page, &figure->curves[c]);
    page_end_table(page);
    fputs("</details>\n", page->out);
}

static void write_verdict(Page *page, const Curve *curve) {
    CurveVerdict verdict = curve_judge(curve);
    fprintf(page->out, "<li><span class=\"%s\">%s</span> ", verdict.holds ? "good" : "bad",
            verdict.holds ? "holds:" : "does not hold:");
    page_text(page, curve->name);
    if (curve->rule == CURVE_SLOPE)
        fprintf(page->out, ", slope %.3f, expected %g ± %.2g", verdict.measured, curve->slope,
                curve->tolerance);
    else if (verdict.share < CURVE_HOPELESS)
        fprintf(page->out, ", %.0f %% of the tolerance used", 100 * verdict.share);
    fputs("</li>\n", page->out);
}

static bool write_figure(Page *page, const RowResult *result, int i, const char *folder) {
    char path[FILES_PATH], name[PLOT_NAME];
    plot_figure_name(name, result->row, i);
    files_join(path, folder, name);
    char *svg = files_read(path, MOST_SVG);
    if (!svg)
        return false;
    fputs("<img class=\"curves\" alt=\"Curves: ", page->out);
    page_text(page, result->findings.figures[i].title);
    fputs(". Their numbers stand below.\" src=\"", page->out);
    page_data(page, "image/svg+xml", svg, strlen(svg));
    fputs("\">", page->out);
    free(svg);
    return true;
}

static bool write_figures(Page *page, const RowResult *result, const char *folder) {
    const Findings *findings = &result->findings;
    bool ok = true;
    fputs("<figure>", page->out);
    for (int i = 0; ok && i < findings->figure_count; i++)
        ok = write_figure(page, result, i, folder);
    fputs("</figure>\n<ul>\n", page->out);
    for (int i = 0; i < findings->figure_count; i++)
        for (int c = 0; c < findings->figures[i].count; c++)
            write_verdict(page, &findings->figures[i].curves[c]);
    fputs("</ul>\n", page->out);
    for (int i = 0; i < findings->figure_count; i++)
        write_numbers(page, &findings->figures[i]);
    return ok;
}

static void write_frame(Page *page, const RowFrame *frame) {
    if (!frame->strip.rgba)
        return;
    fputs("<figure>", page->out);
    page_picture(page, &frame->strip, "strip", "The method, the truth and the error side by side");
    write_element(page, "figcaption", frame->caption);
    fputs("</figure>\n", page->out);
}

// All frames of the sweep, which a slider goes through; hidden where no script runs.
static void write_reel(Page *page, const Reel *reel) {
    if (reel->count < 2)
        return;
    json_t *frames = json_array();
    fprintf(page->out,
            "<figure class=\"reel\" hidden><label>the sweep, frame by frame: <input type=\"range\" min=\"0\" "
            "max=\"%d\" value=\"0\"></label><img class=\"strip\" alt=\"\"><figcaption></figcaption>"
            "<script type=\"application/json\">",
            reel->count - 1);
    for (int i = 0; i < reel->count; i++) {
        char *bytes = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&bytes, &size);
        INVARIANT(out);
        page_base64(out, reel->frames[i].png, reel->frames[i].size);
        fclose(out);
        json_array_append_new(frames, json_pack("[s, s]", reel->frames[i].caption, bytes));
        free(bytes);
    }
    json_dumpf(frames, page->out, JSON_COMPACT | JSON_ENSURE_ASCII | JSON_ESCAPE_SLASH);
    fputs("</script></figure>\n", page->out);
    json_decref(frames);
}

static void write_words(Page *page, const char *title, const char *text) {
    fprintf(page->out, "<p><strong>%s:</strong> ", title);
    page_text(page, text);
    fputs("</p>\n", page->out);
}

static bool write_row(Page *page, const RowResult *result, const char *folder) {
    const Row *row = result->row;
    fprintf(page->out, "<section id=\"row-%d\"><h2>%d. ", row->number, row->number);
    page_text(page, row->name);
    fprintf(page->out, " <span class=\"%s\">%s</span></h2>\n", status_class(result->status),
            status_words(result->status));
    write_words(page, "Method", row->method);
    write_words(page, "Swept", row->sweep);
    write_words(page, "Expected, and why", row->expected);
    write_words(page, "Source", row->source);
    if (result->message[0])
        write_words(page, "It could not go on", result->message);
    bool ok = result->findings.figure_count == 0 || write_figures(page, result, folder);
    write_reel(page, &result->findings.reel);
    for (int i = 0; i < ROW_FRAMES; i++)
        write_frame(page, &result->findings.frames[i]);
    fputs("</section>\n", page->out);
    return ok;
}

char *suite_html(const RowResult *results, int count, const char *folder) {
    Page page;
    int of_status[3] = {0};
    if (!page_begin(&page, "Where methods break"))
        return NULL;
    for (int i = 0; i < count; i++)
        of_status[results[i].status]++;
    fprintf(page.out,
            "<p>Each row sweeps one method over what breaks it. The labs' solutions draw; dashed is what "
            "must come out, the "
            "band around it is the tolerance. A known failure must show and its remedy must hold, or the row "
            "fails.</p>\n"
            "<p>%d rows pass, %d fail, %d are about methods that no lab has yet.</p>\n<p>Frames show the "
            "method, the "
            "ray-traced truth and the error: yellow is false light, blue false shadow, black does not "
            "count.</p>\n"
            "<style>figure img { image-rendering: auto; } figure img.curves { width: 33.5rem; } "
            "figure img.strip { width: 60rem; max-height: 30rem; object-fit: contain; object-position: left; "
            "image-rendering: pixelated; } .reel label { display: flex; flex-wrap: wrap; gap: 0.5rem; "
            "max-width: 100%%; } "
            ".reel input { flex: 1; min-width: 0; "
            "max-width: 40rem; } .state { white-space: nowrap; } @media print { .reel label { display: none; "
            "} }</style>\n",
            of_status[ROW_PASS], of_status[ROW_FAIL], of_status[ROW_NOT_BUILT]);
    write_summary(&page, results, count);
    bool ok = true;
    for (int i = 0; ok && i < count; i++)
        ok = write_row(&page, &results[i], folder);
    fputs("<script>\n", page.out);
    ok = ok && template_copy(page.out, "grader/stability/reel.js");
    fputs("</script>\n", page.out);
    char *text = page_end(&page);
    if (ok)
        return text;
    free(text);
    return NULL;
}
