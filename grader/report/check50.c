#include "report/report.h"

static json_t *plain_cause(const char *rationale) {
    return json_pack("{s:s, s:n, s:n, s:n}", "rationale", rationale, "help", "expected", "actual");
}

// The record that the lab's others depend on: where it fails, they are neither passed nor failed.
static json_t *start_record(const LabResult *lab) {
    bool drawn = result_was_drawn(lab);
    return json_pack("{s:o, s:o, s:b, s:[s], s:o, s:n}", "name", json_sprintf("lab%s", lab->id),
                     "description", json_sprintf("lab %s compiles and draws", lab->id), "passed", drawn,
                     "log", lab->message, "cause", drawn ? json_null() : plain_cause(lab->message),
                     "dependency");
}

static json_t *cause_of(const CheckResult *check) {
    if (!check->yours[0].rgba)
        return plain_cause("the lab did not draw it");
    if (!check->has_cause)
        return check->passed ? json_null() : plain_cause("the picture differs from the reference");
    return json_pack("{s:s, s:s, s:n, s:n}", "rationale", check->mistake, "help", check->hint, "expected",
                     "actual");
}

static json_t *log_of(const LabResult *lab, const CheckResult *check) {
    json_t *log = json_array();
    json_array_append_new(log, json_sprintf("task %s: %.2f of %d points", check->check->task,
                                            result_points(check), check->check->points));
    if (!check->passed && check->seen[0])
        json_array_append_new(log, json_string(check->seen));
    if (!check->passed && lab->summary[0])
        json_array_append_new(log, json_string(lab->summary));
    return log;
}

static json_t *check_record(const LabResult *lab, int c) {
    const CheckResult *check = &lab->checks[c];
    bool known = check->yours[0].rgba || result_was_drawn(lab);
    return json_pack("{s:o, s:s, s:o, s:o, s:o, s:o, s:{s:f, s:i}}", "name",
                     json_sprintf("lab%s_%d", lab->id, c + 1), "description", check->check->name, "passed",
                     known ? json_boolean(check->passed) : json_null(), "log", log_of(lab, check), "cause",
                     cause_of(check), "dependency", json_sprintf("lab%s", lab->id), "data", "score",
                     result_points(check), "max_score", check->check->points);
}

// The lab's last record: right or wrong whether it draws or not.
static json_t *predictions_record(const LabResult *lab) {
    const Predictions *predictions = &lab->predictions;
    const int points = predictions_points(predictions), most = predictions_max_points(predictions);
    json_t *log = json_array();
    for (int n = 0; n < predictions->count; n++)
        if (predictions->results[n].why[0])
            json_array_append_new(log, json_sprintf("%c: %s", 'a' + n, predictions->results[n].why));
    const char *why = predictions->message[0] ? predictions->message : "not all numbers are right";
    return json_pack("{s:o, s:s, s:b, s:o, s:o, s:n, s:{s:i, s:i}}", "name",
                     json_sprintf("lab%s_%d", lab->id, lab->check_count + 1), "description",
                     "predictions, without which a lab passes, too", "passed", points == most, "log", log,
                     "cause", points == most ? json_null() : plain_cause(why), "dependency", "data", "score",
                     points, "max_score", most);
}

json_t *report_check50(const Report *report) {
    json_t *results = json_array();
    for (int i = 0; i < report->lab_count; i++) {
        json_array_append_new(results, start_record(&report->labs[i]));
        for (int c = 0; c < report->labs[i].check_count; c++)
            json_array_append_new(results, check_record(&report->labs[i], c));
        if (report->labs[i].predictions.count > 0)
            json_array_append_new(results, predictions_record(&report->labs[i]));
    }
    return json_pack("{s:s, s:o, s:s}", "slug", "shadow-lab", "results", results, "version", "1");
}
