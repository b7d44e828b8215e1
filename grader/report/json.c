#include "report/report.h"

#include <jansson.h>
#include <math.h>

static double rounded(double value, double unit) {
    return round(value / unit) * unit;
}

static json_t *cause_json(const CheckResult *check) {
    return check->has_cause ? json_pack("{s:s, s:s, s:s, s:s}", "mistake", check->mistake, "kind",
                                        check->kind, "hint", check->hint, "seen", check->seen)
                            : json_null();
}

static json_t *check_json(const CheckResult *check) {
    return json_pack("{s:s, s:s, s:s, s:f, s:i, s:b, s:f, s:o}", "name", check->check->name, "stage",
                     check->check->view, "task", check->check->task, "score", result_points(check),
                     "max_score", check->check->points, "passed", check->passed, "error",
                     rounded(check->error, 1e-6), "cause", cause_json(check));
}

// The parts with the fault; an empty list when none was found.
static json_t *parts_json(const Fault *fault) {
    json_t *parts = json_array();
    for (int i = 0; i < fault->count; i++) {
        const FaultPart *part = &fault->parts[i];
        json_t *tasks = json_array();
        for (int k = 0; k < FAULT_TASKS && part->tasks[k]; k++)
            json_array_append_new(tasks, json_string(part->tasks[k]));
        json_array_append_new(parts, json_pack("{s:s, s:s, s:o}", "file", part->file, "function",
                                               part->function, "tasks", tasks));
    }
    return parts;
}

static json_t *summary_json(const LabResult *lab) {
    if (!lab->summary[0])
        return json_null();
    return json_pack("{s:s, s:s, s:o, s:i, s:i}", "text", lab->summary, "hint", lab->advice, "parts",
                     parts_json(&lab->fault), "failed", lab->fault.failed, "repaired", lab->fault.repaired);
}

static json_t *predictions_json(const Predictions *predictions) {
    json_t *results = json_array();
    for (int n = 0; n < predictions->count; n++) {
        const PredictionResult *result = &predictions->results[n];
        json_array_append_new(results, json_pack("{s:s#, s:s, s:s, s:b, s:i, s:i, s:s}", "id",
                                                 &(char){(char)('a' + n)}, 1, "question", result->question,
                                                 "typed", result->typed, "right", result->right, "score",
                                                 result->right ? result->points : 0, "max_score",
                                                 result->points, "message", result->why));
    }
    return json_pack("{s:I, s:s, s:o}", "sheet", (json_int_t)predictions->sheet, "message",
                     predictions->message, "results", results);
}

static json_t *lab_json(const LabResult *lab) {
    json_t *checks = json_array();
    for (int c = 0; c < lab->check_count; c++)
        json_array_append_new(checks, check_json(&lab->checks[c]));
    return json_pack("{s:s, s:s, s:b, s:f, s:f, s:s, s:s, s:s, s:f, s:o, s:o, s:o}", "id", lab->id, "name",
                     lab->name, "handed_in", !lab->missing, "score", rounded(lab->score, 0.01), "max_score",
                     lab->max_score, "status", result_status_name(lab->status), "message", lab->message,
                     "warnings", lab->warnings, "speed_ratio", rounded(lab->speed_ratio, 0.001), "summary",
                     summary_json(lab), "checks", checks, "predictions", predictions_json(&lab->predictions));
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
