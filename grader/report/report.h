// Reports of one submission, for people and for programs.
#pragma once

#include "diagnose/result.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

typedef enum ReportFormat {
    REPORT_TEXT,
    REPORT_JSON,
    REPORT_HTML,
    REPORT_GRADESCOPE,
    REPORT_CHECK50
} ReportFormat;

// "text", ...: false when there is no such format.
bool report_parse_format(ReportFormat *format, const char *name);

// Prints the report; text with colours when `out` is a terminal. False with a message when it cannot be
// written.
bool report_print(const Report *report, ReportFormat format, FILE *out);

// One line a check, a bar a lab; with the colours of a terminal when `color`. Texts break at words within
// `columns` characters (0: nowhere).
void report_text(const Report *report, FILE *out, bool color, int columns);

// The JSON of grader/report/report.schema.json, to be freed by the caller (json_decref); NULL when out of
// memory.
json_t *report_json(const Report *report);

// The results.json of a Gradescope autograder (report/gradescope.schema.json); freed by the caller.
json_t *report_gradescope(const Report *report);

// Records in the manner of check50 (report/check50.schema.json); freed by the caller.
json_t *report_check50(const Report *report);

// A page that needs no other file, with the pictures of what failed. `name` is whose it is, "" for nobody's.
// The caller frees it; NULL with a message.
char *report_html(const Report *report, const char *name);
