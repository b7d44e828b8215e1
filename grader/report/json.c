#include "report/report.h"

#include <jansson.h>
#include <math.h>

static double rounded(double value, double unit) {
    return round(value / unit) * unit;
}

static json_t *cause_json(const CheckResult *check) {
    return check->has_cause ? json_pack("{s:s, s:s, s:s}", "mistake", check->mistake, "kind", check->kind,
                                        "hint", check->hint)
                            : json_null();
}

static json_t *check_json(const CheckResult *check) {
    return json_pack("{s:s, s:s, s:s, s:f, s:i, s:b, s:f, s:o}", "name", check->check->name, "stage",
                     check->check->view, "task", check->check->task, "score", result_points(check),
                     "max_score", check->check->points, "passed", check->passed, "error",
                     rounded(check->error, 1e-6), "cause", cause_json(check));
}

static json_t *lab_json(const LabResult *lab) {
    json_t *checks = json_array();
    for (int c = 0; c < lab->check_count; c++)
        json_array_append_new(checks, check_json(&lab->checks[c]));
    return json_pack("{s:s, s:s, s:f, s:f, s:s, s:s, s:s, s:f, s:o}", "id", lab->id, "name", lab->name,
                     "score", rounded(lab->score, 0.01), "max_score", lab->max_score, "status",
                     result_status_name(lab->status), "message", lab->message, "warnings", lab->warnings,
                     "speed_ratio", rounded(lab->speed_ratio, 0.001), "checks", checks);
}

json_t *report_json(const Report *report) {
    json_t *labs = json_array();
    for (int i = 0; i < report->lab_count; i++)
        json_array_append_new(labs, lab_json(&report->labs[i]));
    char seed[24];
    snprintf(seed, sizeof seed, "%llu", (unsigned long long)report->seed);
    return json_pack("{s:i, s:s, s:s, s:s, s:s, s:f, s:f, s:f, s:o}", "version", 1, "seed", seed, "context",
                     report->context, "jail", report->jail, "renderer", report->renderer, "seconds",
                     rounded(report->seconds, 0.001), "score", rounded(result_score(report), 0.01),
                     "max_score", result_max_score(report), "labs", labs);
}
