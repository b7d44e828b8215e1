// Prints a report as text: a line a check, where to look first, a bar a lab; on a terminal in colours and
// broken at words.
#include "report/report.h"

#include "base/color.h"

#include <string.h>

enum { BAR = 30, LEAST = 20 };

typedef struct Colors {
    const char *good, *bad, *note, *dim, *bold, *end;
    int columns; // where lines are broken; 0: nowhere
} Colors;

// How much of a line goes onto one of the terminal: up to the last space that fits.
static int break_at(const char *line, int length, int width) {
    if (length <= width)
        return length;
    for (int at = width; at > 0; at--)
        if (line[at] == ' ')
            return at;
    return length;
}

// Prints a text of several lines, each behind `prefix`; on a terminal they break at words, and go on below.
static void print_lines(FILE *out, const char *prefix, const char *text, const Colors *colors) {
    const int width = colors->columns - (int)strlen(prefix);
    for (bool begins = true; *text;) {
        const int line = (int)strcspn(text, "\n");
        const int length = colors->columns ? break_at(text, line, width > LEAST ? width : LEAST) : line;
        fprintf(out, "%*s%.*s\n", (int)strlen(prefix), begins ? prefix : "", length, text);
        begins = length == line;
        text += length;
        text += *text == '\n' || *text == ' ';
    }
}

// Hints are for what is wrong, and for the first task that is not done: who reads on would learn too early
// what comes later.
static void print_check(const CheckResult *check, const CheckResult *before, bool hinted, FILE *out,
                        const Colors *colors) {
    fprintf(out, "  %s%s%s %6.2f/%-3d %-4s %s%s\n", check->passed ? colors->good : colors->bad,
            check->passed ? "ok  " : "FAIL", colors->end, result_points(check), check->check->points,
            check->check->task, check->check->name, check->check->optional ? " (optional)" : "");
    if (!check->has_cause)
        return;
    if (!before || strcmp(before->mistake, check->mistake) != 0)
        fprintf(out, "         %s%s%s\n", colors->bold, check->mistake, colors->end);
    if (check->seen[0] && (!before || strcmp(before->seen, check->seen) != 0))
        print_lines(out, "         ", check->seen, colors);
    if (hinted)
        print_lines(out, "         ", check->hint, colors);
}

// Where to look first, and why.
static void print_summary(const LabResult *lab, FILE *out, const Colors *colors) {
    if (!lab->summary[0])
        return;
    fprintf(out, "  %s=> %s%s\n", colors->bold, lab->summary, colors->end);
    print_lines(out, "     ", lab->advice, colors);
}

// The checks of a lab, and where to go on.
static void print_checks(const LabResult *lab, FILE *out, const Colors *colors) {
    const CheckResult *before = NULL, *first = NULL;
    for (int c = 0; c < lab->check_count; c++) {
        const CheckResult *check = &lab->checks[c];
        const bool told =
            (before && strcmp(before->hint, check->hint) == 0) || strcmp(lab->advice, check->hint) == 0;
        print_check(check, before, !told && (!check->undone || !first || !first->undone), out, colors);
        before = check->has_cause ? check : before;
        first = first ? first : check->has_cause ? check : NULL;
    }
    const char *task = first && first->cause_task ? first->cause_task : first ? first->check->task : "";
    if (strchr(task, '.'))
        fprintf(out, "  %sMore hints: make hint TASK=%s%s\n", colors->dim, task, colors->end);
}

static void print_prediction(const PredictionResult *result, int n, FILE *out, const Colors *colors) {
    const char *color = result->right ? colors->good : result->typed[0] ? colors->bad : "";
    fprintf(out, "  %s%s%s %6d/%-3d %-4c %s\n", color,
            result->right      ? "ok  "
            : result->typed[0] ? "FAIL"
                               : "open",
            color[0] ? colors->end : "", result->right ? result->points : 0, result->points, 'a' + n,
            result->right ? result->typed : "");
    print_lines(out, "         ", result->why, colors);
}

static bool any_typed(const Predictions *predictions) {
    for (int n = 0; n < predictions->count; n++)
        if (predictions->results[n].typed[0])
            return true;
    return false;
}

// The numbers that were predicted; none while there is no sheet to judge them by.
static void print_predictions(const Predictions *predictions, FILE *out, const Colors *colors) {
    if (predictions->count == 0)
        return;
    fprintf(out, "  %spredictions %d/%d%s (a lab passes without them)\n", colors->bold,
            predictions_points(predictions), predictions_max_points(predictions), colors->end);
    if (predictions->message[0])
        print_lines(out, "         ", predictions->message, colors);
    if (predictions->sheet && !any_typed(predictions))
        print_lines(out, "         ", "nothing is typed yet into predictions.txt", colors);
    for (int n = 0; any_typed(predictions) && predictions->sheet && n < predictions->count; n++)
        print_prediction(&predictions->results[n], n, out, colors);
}

static void print_bar(double share, FILE *out) {
    int full = (int)(share * BAR + 1e-9);
    fputc('[', out);
    for (int i = 0; i < BAR; i++)
        fputc(i < full ? '#' : '.', out);
    fputc(']', out);
}

static void print_lab(const LabResult *lab, FILE *out, const Colors *colors) {
    fprintf(out, "%sLab %s: %s%s\n", colors->bold, lab->id, lab->name, colors->end);
    if (lab->message[0])
        print_lines(out, "  ! ", lab->message, colors);
    if (lab->warnings[0]) {
        fputs(colors->note, out);
        print_lines(out, "  note: ", lab->warnings, colors);
        fputs(colors->end, out);
    }
    print_summary(lab, out, colors);
    print_checks(lab, out, colors);
    print_predictions(&lab->predictions, out, colors);
    fputs("  ", out);
    print_bar(lab->max_score > 0 ? lab->score / lab->max_score : 0, out);
    fprintf(out, " %.2f of %.0f points, %s%s%s", lab->score, lab->max_score,
            lab->status == LAB_PASSED ? colors->good : colors->bad, result_status_name(lab->status),
            colors->end);
    if (lab->status == LAB_PASSED && lab->speed_ratio > 0)
        fprintf(out, "; %.2f times the solution's time", lab->speed_ratio);
    fputs("\n\n", out);
}

void report_text(const Report *report, FILE *out, bool color, int columns) {
    const Colors plain = {"", "", "", "", "", "", columns};
    const Colors colored = {color_begin(COLOR_GOOD),
                            color_begin(COLOR_BAD),
                            color_begin(COLOR_NOTE),
                            color_begin(COLOR_DIM),
                            color_begin(COLOR_BOLD),
                            COLOR_END,
                            columns};
    const Colors colors = color ? colored : plain;
    for (int i = 0; i < report->lab_count; i++)
        print_lab(&report->labs[i], out, &colors);
    fprintf(out, "%s%.2f of %.0f points%s (seed %llu, %s, %.1f s)\n", colors.bold, result_score(report),
            result_max_score(report), colors.end, (unsigned long long)report->seed, report->context,
            report->seconds);
}
