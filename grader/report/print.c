#include "report/report.h"

#include "base/color.h"
#include "scene/check.h"
#include "scene/count.h"

#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>

static const char *const formats[] = {"text", "json", "html", "gradescope", "check50"};

bool report_parse_format(ReportFormat *format, const char *name) {
    for (size_t i = 0; i < COUNT(formats); i++)
        if (strcmp(formats[i], name) == 0) {
            *format = (ReportFormat)i;
            return true;
        }
    return false;
}

// 0 when it is no terminal.
static int columns_of(FILE *out) {
    struct winsize size = {0};
    return ioctl(fileno(out), TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

static bool print_json(json_t *json, FILE *out) {
    bool ok = json && json_dumpf(json, out, JSON_INDENT(2) | JSON_REAL_PRECISION(10)) == 0 &&
              fputc('\n', out) != EOF;
    json_decref(json);
    return ok;
}

static bool print_html(const Report *report, FILE *out) {
    char *page = report_html(report, "");
    bool ok = page && fputs(page, out) >= 0;
    free(page);
    return ok;
}

bool report_print(const Report *report, ReportFormat format, FILE *out) {
    bool ok = true;
    if (format == REPORT_TEXT)
        report_text(report, out, color_wanted(out), columns_of(out));
    else if (format == REPORT_HTML)
        ok = print_html(report, out);
    else if (format == REPORT_GRADESCOPE)
        ok = print_json(report_gradescope(report), out);
    else if (format == REPORT_CHECK50)
        ok = print_json(report_check50(report), out);
    else
        ok = print_json(report_json(report), out);
    return (ok && fflush(out) == 0) || check_fail("the report cannot be written");
}
