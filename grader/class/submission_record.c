#include "class/submission_record.h"

#include "scene/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define TIME_FORM "%Y-%m-%dT%H:%M:%SZ" // ISO 8601, as gmtime_r has it

static void place(char path[FILES_PATH], const char *output, const char *kind, const RosterEntry *entry,
                  const char *end) {
    int length = snprintf(path, FILES_PATH, "%s/%s/%s.%s", output, kind, entry->file, end);
    INVARIANT(length < FILES_PATH);
}

static json_t *time_json(const HandInFacts *facts) {
    char text[24];
    struct tm parts;
    if (facts->time == 0 || !gmtime_r(&facts->time, &parts) ||
        strftime(text, sizeof text, TIME_FORM, &parts) == 0)
        return json_null();
    return json_pack("{s:s, s:b}", "time", text, "told", facts->told);
}

static bool write_record(const char *output, const RosterEntry *entry, const char *reason, json_t *made_of,
                         json_t *handed_in, json_t *report) {
    char path[FILES_PATH];
    json_t *root = json_pack("{s:i, s:s, s:b, s:s, s:o, s:o, s:o}", "version", 1, "submission", entry->shown,
                             "graded", reason[0] == '\0', "reason", reason, "made_of", made_of, "handed_in",
                             handed_in, "report", report);
    char *text = root ? json_dumps(root, JSON_INDENT(1) | JSON_REAL_PRECISION(10)) : NULL;
    json_decref(root);
    place(path, output, "results", entry, "json");
    bool ok = text ? files_write_whole(path, text, true)
                   : check_fail("the record of \"%s\" is no JSON", entry->shown);
    free(text);
    return ok;
}

static bool write_page(const char *output, const RosterEntry *entry, const Report *report) {
    char path[FILES_PATH];
    char *page = report_html(report, entry->shown);
    place(path, output, "pages", entry, "html");
    bool ok = page && files_write_whole(path, page, true);
    free(page);
    return ok;
}

bool submission_record_write(const char *output, const RosterEntry *entry, const Report *report,
                             json_t *made_of, const HandInFacts *facts) {
    if (write_page(output, entry, report))
        return write_record(output, entry, "", made_of, time_json(facts), report_json(report));
    json_decref(made_of);
    return false;
}

bool submission_record_write_failure(const char *output, const RosterEntry *entry, const char *reason) {
    char path[FILES_PATH], *shown = printable_name(reason);
    place(path, output, "pages", entry, "html");
    unlink(path);
    bool ok =
        write_record(output, entry, shown[0] ? shown : "unknown", json_null(), json_null(), json_null());
    free(shown);
    return ok;
}

json_t *submission_record_read(const char *output, const RosterEntry *entry) {
    char path[FILES_PATH];
    place(path, output, "results", entry, "json");
    json_t *root = json_load_file(path, 0, NULL);
    const char *name = json_string_value(json_object_get(root, "submission"));
    if (name && strcmp(name, entry->shown) == 0 && json_integer_value(json_object_get(root, "version")) == 1)
        return root;
    json_decref(root);
    return NULL;
}

time_t submission_record_time(const json_t *record, bool *told) {
    const json_t *handed_in = json_object_get(record, "handed_in");
    const char *text = json_string_value(json_object_get(handed_in, "time"));
    struct tm parts = {0};
    *told = json_is_true(json_object_get(handed_in, "told"));
    return text && strptime(text, TIME_FORM, &parts) ? timegm(&parts) : 0;
}

bool submission_record_is_graded(const json_t *record) {
    return json_is_true(json_object_get(record, "graded")) &&
           json_is_object(json_object_get(record, "report"));
}
