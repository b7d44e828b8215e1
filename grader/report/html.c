// The report of one submission as a page: each check with its cause and the pictures of what failed.
#include "report/report.h"

#include "pages/page.h"

#include <string.h>

static const char *class_of(bool good) {
    return good ? "good" : "bad";
}

// A hint that stands above already, at `before`, is not said again.
static void write_check(Page *page, const CheckResult *check, const CheckResult *before) {
    fprintf(page->out, "<tr><td class=\"%s\">%s</td><td>%s</td><td>", class_of(check->passed),
            check->passed ? "passed" : "failed", check->check->task);
    page_text(page, check->check->name);
    fprintf(page->out,
            "%s</td>" PAGE_POINTS "<td class=\"number\">%.2f of %d</td>" PAGE_POINTS_END
            "<td class=\"said\">",
            check->check->optional ? " <span class=\"quiet\">(optional)</span>" : "", result_points(check),
            check->check->points);
    if (check->has_cause) {
        fputs("<strong>", page->out);
        page_prose(page, check->mistake);
        fputs("</strong>", page->out);
        if (check->seen[0]) {
            fputs("<p>", page->out);
            page_prose(page, check->seen);
            fputs("</p>", page->out);
        }
        if (!before || strcmp(before->hint, check->hint) != 0) {
            fputs("<p class=\"hint\">", page->out);
            page_prose(page, check->hint);
            fputs("</p>", page->out);
        }
    }
    fputs("</td></tr>\n", page->out);
}

static void write_checks(Page *page, const LabResult *lab) {
    const CheckResult *before = NULL;
    char label[40];
    snprintf(label, sizeof label, "Checks of lab %s", lab->id);
    page_begin_table(page, label,
                     (const char *const[]){"result", "task", "check", "#points", "what is wrong", NULL});
    for (int c = 0; c < lab->check_count; c++) {
        write_check(page, &lab->checks[c], before);
        before = lab->checks[c].has_cause ? &lab->checks[c] : before;
    }
    page_end_table(page);
}

static void write_prediction(Page *page, const PredictionResult *result, int n) {
    fprintf(page->out, "<tr><td class=\"%s\">%s</td><td>%c</td><td>", class_of(result->right),
            result->right      ? "right"
            : result->typed[0] ? "wrong"
                               : "open",
            'a' + n);
    page_text(page, result->question);
    fputs("</td><td>", page->out);
    page_text(page, result->typed);
    fprintf(page->out,
            "</td>" PAGE_POINTS "<td class=\"number\">%d of %d</td>" PAGE_POINTS_END "<td class=\"said\">",
            result->right ? result->points : 0, result->points);
    page_prose(page, result->why);
    fputs("</td></tr>\n", page->out);
}

// What was predicted, which counts points and is not needed to pass.
static void write_predictions(Page *page, const LabResult *lab) {
    const Predictions *predictions = &lab->predictions;
    char label[40];
    if (predictions->count == 0)
        return;
    fprintf(page->out, "<h3>Predictions</h3>\n<p>" PAGE_POINTS "%d of %d points%s" PAGE_POINTS_END,
            predictions_points(predictions), predictions_max_points(predictions),
            predictions->message[0] ? ": " : "");
    page_prose(page, predictions->message);
    fputs(" <span class=\"quiet\">(A lab passes without them.)</span></p>\n", page->out);
    if (!predictions->sheet)
        return;
    snprintf(label, sizeof label, "Predictions of lab %s", lab->id);
    page_begin_table(
        page, label,
        (const char *const[]){"result", "id", "question", "predicted", "#points", "what is wrong", NULL});
    for (int n = 0; n < predictions->count; n++)
        write_prediction(page, &predictions->results[n], n);
    page_end_table(page);
}

static void write_key(Page *page, int color) {
    fprintf(page->out, "<span class=\"key\" style=\"background:#%06x\"></span> ", (unsigned)color);
}

static void write_caption(Page *page, const CheckResult *check) {
    const Difference *wrong = &check->difference;
    fprintf(page->out, "<figcaption>Of %zu pixels ", image_bytes(&check->yours[check->worst]) / 4);
    write_key(page, DIFFERENCE_BRIGHTER);
    fprintf(page->out, "%zu are too bright (yellow), ", wrong->brighter);
    write_key(page, DIFFERENCE_DARKER);
    fprintf(page->out, "%zu too dark (blue), ", wrong->darker);
    write_key(page, DIFFERENCE_OTHER);
    fprintf(page->out, "%zu of another colour (magenta).</figcaption>\n", wrong->other);
}

static void write_evidence(Page *page, const LabResult *lab, int c) {
    const CheckResult *check = &lab->checks[c];
    const Image *parts = check->evidence;
    fprintf(page->out, "<h3>%s ", check->check->task);
    page_text(page, check->check->name);
    fputs("</h3>\n<figure>\n<div><div class=\"compare\">", page->out);
    page_picture(page, &parts[EVIDENCE_YOURS], "yours", "yours");
    page_picture(page, &parts[EVIDENCE_REFERENCE], "reference", "reference");
    fprintf(page->out,
            "</div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" data-compare=\"yours|reference\" "
            "aria-valuetext=\"50 %% "
            "yours, 50 %% reference\" aria-label=\"%s: how much of yours is seen\"><div "
            "class=\"ends\"><span>left of "
            "the line: yours</span><span>right: reference</span></div></div>\n<div>",
            check->check->task);
    page_picture(page, &parts[EVIDENCE_DIFFERENCE], "difference", "difference");
    fputs("<span class=\"quiet\">difference</span></div>\n<div>", page->out);
    page_picture(page, &parts[EVIDENCE_CROP], "crop",
                 "yours, reference and difference side by side, enlarged where most is wrong");
    fputs("<span class=\"quiet\">enlarged where most is wrong: yours, reference, difference</span></div>\n",
          page->out);
    write_caption(page, check);
    fputs("</figure>\n", page->out);
}

static void write_words(Page *page, const char *title, const char *text) {
    if (!text[0])
        return;
    fprintf(page->out, "<h3>%s</h3>\n<pre tabindex=\"0\">", title);
    page_text(page, text);
    fputs("</pre>\n", page->out);
}

static void write_lab(Page *page, const LabResult *lab) {
    fprintf(page->out, "<h2>Lab %s: ", lab->id);
    page_text(page, lab->name);
    fprintf(page->out,
            "</h2>\n<p>" PAGE_POINTS
            "<meter min=\"0\" max=\"%.0f\" value=\"%.2f\" aria-label=\"points\"></meter> %.2f of "
            "%.0f points, " PAGE_POINTS_END "<span class=\"%s\">%s</span>",
            lab->max_score, lab->score, lab->score, lab->max_score, class_of(lab->status == LAB_PASSED),
            result_status_name(lab->status));
    if (lab->speed_ratio > 0)
        fprintf(page->out, "; %.2f times the solution's time", lab->speed_ratio);
    fputs("</p>\n", page->out);
    if (lab->summary[0]) {
        fputs("<p><strong>", page->out);
        page_prose(page, lab->summary);
        fputs("</strong></p>\n", page->out);
    }
    write_words(page, "Message", lab->message);
    if (lab->missing) // nothing was checked
        return;
    write_checks(page, lab);
    write_predictions(page, lab);
    write_words(page, "Notes", lab->warnings);
    for (int c = 0; c < lab->check_count; c++)
        if (lab->checks[c].evidence[0].rgba)
            write_evidence(page, lab, c);
}

char *report_html(const Report *report, const char *name) {
    Page page;
    if (!page_begin(&page, name[0] ? name : "Shadow Lab"))
        return NULL;
    fprintf(page.out, "<p>" PAGE_POINTS "%.2f of %.0f points " PAGE_POINTS_END "<span class=\"quiet\">(",
            result_score(report), result_max_score(report));
    if (!report->hidden)
        fprintf(page.out, "seed %llu, ", (unsigned long long)report->seed);
    fputs(report->context, page.out);
    fputs(report->renderer[0] ? ", " : "", page.out);
    page_text(&page, report->renderer);
    fputs(")</span></p>\n", page.out);
    for (int i = 0; i < report->lab_count; i++)
        write_lab(&page, &report->labs[i]);
    return page_end(&page);
}
