// The report as Gradescope reads it: a test a check, and one for the predictions of a lab.
#include "report/report.h"

#include "pages/page.h"
#include "scene/check.h"

#include <math.h>
#include <stdlib.h>

static double cents(double points) {
    return round(points * 100) / 100;
}

static void add_line(Page *page, const char *text) {
    fputs("<p style=\"white-space: pre-line\">", page->out);
    page_text(page, text);
    fputs("</p>", page->out);
}

// The cause, and yours, the reference and their difference side by side where most is wrong. Gradescope shows
// pictures only in HTML, as data: URIs.
static json_t *output_json(const LabResult *lab, const CheckResult *check) {
    Page page = {0};
    page.out = open_memstream(&page.text, &page.size);
    INVARIANT(page.out);
    if (check->has_cause) {
        add_line(&page, check->mistake);
        if (check->seen[0])
            add_line(&page, check->seen);
        add_line(&page, check->hint);
    } else if (!check->passed) {
        add_line(&page, lab->message);
    }
    if (check->evidence[EVIDENCE_CROP].rgba) {
        page_picture(&page, &check->evidence[EVIDENCE_CROP], "crop",
                     "yours, reference and difference side by side, enlarged where most is wrong");
        fputs("<p>yours, reference, difference</p>", page.out);
    }
    fclose(page.out);
    json_t *output = json_string(page.text);
    free(page.text);
    return output;
}

static json_t *test_json(const LabResult *lab, const CheckResult *check) {
    return json_pack("{s:o, s:s, s:f, s:i, s:s, s:o, s:s, s:s}", "name",
                     json_sprintf("Lab %s: %s", lab->id, check->check->name), "number", check->check->task,
                     "score", result_points(check), "max_score", check->check->points, "status",
                     check->passed ? "passed" : "failed", "output", output_json(lab, check), "output_format",
                     "html", "visibility", "visible");
}

// The lab's last test: what was predicted, a line each.
static json_t *predictions_output(const Predictions *predictions) {
    Page page = {0};
    page.out = open_memstream(&page.text, &page.size);
    INVARIANT(page.out);
    add_line(&page, "A lab passes without them.");
    add_line(&page, predictions->message);
    for (int n = 0; predictions->sheet && n < predictions->count; n++) {
        const PredictionResult *result = &predictions->results[n];
        char text[1100];
        snprintf(text, sizeof text, "%c: %s%s", 'a' + n, result->right ? "right: " : "",
                 result->right ? result->typed : result->why);
        add_line(&page, text);
    }
    fclose(page.out);
    json_t *output = json_string(page.text);
    free(page.text);
    return output;
}

static json_t *predictions_json(const LabResult *lab) {
    const Predictions *predictions = &lab->predictions;
    const int points = predictions_points(predictions), most = predictions_max_points(predictions);
    return json_pack("{s:o, s:s, s:i, s:i, s:s, s:o, s:s, s:s}", "name",
                     json_sprintf("Lab %s: predictions", lab->id), "number", lab->id, "score", points,
                     "max_score", most, "status", points == most ? "passed" : "failed", "output",
                     predictions_output(predictions), "output_format", "html", "visibility", "visible");
}

// What concerns a lab as a whole.
static void add_words(char *text, size_t size, const LabResult *lab) {
    if (lab->summary[0])
        check_append(text, size, "Lab %s: %s\n", lab->id, lab->summary);
    if (lab->message[0])
        check_append(text, size, "Lab %s, %s: %s\n", lab->id, result_status_name(lab->status), lab->message);
    if (lab->warnings[0])
        check_append(text, size, "Lab %s, notes: %s\n", lab->id, lab->warnings);
}

json_t *report_gradescope(const Report *report) {
    static char words[2 * RESULT_TEXT];
    words[0] = '\0';
    json_t *tests = json_array();
    for (int i = 0; i < report->lab_count; i++) {
        const LabResult *lab = &report->labs[i];
        add_words(words, sizeof words, lab);
        for (int c = 0; c < lab->check_count; c++)
            json_array_append_new(tests, test_json(lab, &lab->checks[c]));
        if (lab->predictions.count > 0)
            json_array_append_new(tests, predictions_json(lab));
    }
    json_t *seed = json_sprintf("%llu", (unsigned long long)report->seed);
    return json_pack("{s:f, s:f, s:s, s:s, s:s, s:s, s:{s:o, s:s, s:f}, s:o}", "score",
                     cents(result_score(report)), "execution_time", round(report->seconds * 1000) / 1000,
                     "output", words, "output_format", "text", "visibility", "visible", "stdout_visibility",
                     "hidden", "extra_data", "seed", seed, "renderer", report->renderer, "max_score",
                     result_max_score(report), "tests", tests);
}
