#include "grade/lab_verdict.h"

#include "scene/check.h"

#include <stdio.h>
#include <string.h>

void grade_warn(LabResult *result, const char *text) {
    char clean[RESULT_TEXT];
    result_clean(clean, sizeof clean, text);
    if (clean[0] && !strstr(result->warnings, clean))
        check_append(result->warnings, sizeof result->warnings, "%s%s", result->warnings[0] ? "\n" : "",
                     clean);
}

void grade_begin(LabResult *result, const Rubric *rubric) {
    memset(result, 0, sizeof *result);
    memcpy(result->id, rubric->id, sizeof result->id);
    snprintf(result->name, sizeof result->name, "%s", rubric->title);
    result->max_score = rubric_points(rubric);
    result->check_count = rubric->check_count;
    for (int c = 0; c < rubric->check_count; c++)
        result->checks[c] = (CheckResult){.check = &rubric->checks[c], .error = 1};
    predictions_begin(&result->predictions, rubric);
}

void grade_fail(LabResult *result, LabStatus status, const char *message) {
    if (result->message[0])
        return;
    result->status = status;
    result_clean(result->message, sizeof result->message, message);
}

void grade_refuse(LabResult *result, const char *reason) {
    grade_fail(result, LAB_ERROR, reason);
}

void grade_quote(LabResult *result, const char *printed) {
    enum { MAX_LINES = 12, MAX_TEXT = 1000 };
    char text[MAX_TEXT + 64] = "it printed:";
    const char *end = printed;
    for (int line = 0; *end && line < MAX_LINES && end - printed < MAX_TEXT; line++) {
        end += strcspn(end, "\n");
        end += *end == '\n';
    }
    const int length = end - printed < MAX_TEXT ? (int)(end - printed) : MAX_TEXT;
    check_append(text, sizeof text, "\n%.*s%s", length, printed, printed[length] ? "..." : "");
    if (length > 0)
        grade_warn(result, text);
}
