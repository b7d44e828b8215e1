// Writes a lab's screen, the list of labs, and the line of keys at the bottom.
#include "watch/screens.h"

#include "watch/after_lab.h"
#include "watch/predict_first.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { BAR = 24, WIDE_BAR = 40, LEAST_BAR = 8 };
enum { NAME = 48, TITLE = 31, LEAST_NAME = 8, POINTS = 12 }; // columns of names, and of " 99.9 of 100"
enum {
    SHORT_REMARK = 16,
    LONG_REMARK = 36
}; // with what stands before a lab's title: "99 of 100", also when done

// Points are rounded down: what is not whole must not look as if it were.
static double round_down(double points, double step) {
    return floor(points / step + 1e-6) * step;
}

static const char *points_text(char text[16], double points) {
    snprintf(text, 16, "%4.3g", round_down(points, 0.1));
    return text;
}

static double share(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

static int within(int value, int least, int most) {
    return value < least ? least : value > most ? most : value;
}

// "[###...] " as wide as there is room beside `taken` columns, at most `width` between the brackets; "" where
// that is too little to tell anything.
static void fit_bar(char bar[WIDE_BAR + 8], const Sheet *sheet, int taken, int width, double share) {
    const int room = within(sheet->columns - taken - (int)strlen("[] "), 0, width);
    bar[0] = '\0';
    if (room < LEAST_BAR)
        return;
    sheet_bar(bar, WIDE_BAR + 7, share, room);
    strcat(bar, " ");
}

// A line in bold, with a bar between its two parts where there is room.
static void show_share(Sheet *sheet, const char *before, const char *after, int width, double share) {
    char bar[WIDE_BAR + 8];
    fit_bar(bar, sheet, (int)(strlen(before) + strlen(after)), width, share);
    sheet_wrapped(sheet, STYLE_BOLD, 0, "%s%s%s", before, bar, after);
}

static void show_total(Sheet *sheet, const LabBoard *board) {
    char points[100];
    const double score = lab_board_score(board), max_score = lab_board_max_score(board);
    snprintf(points, sizeof points, "%.0f of %.0f points, %d of %d labs done", round_down(score, 1),
             max_score, lab_board_done(board), board->lab_count);
    show_share(sheet, "Shadow Lab  ", points, sheet->columns < 96 ? BAR : WIDE_BAR, share(score, max_score));
    sheet_line(sheet, STYLE_PLAIN, "%s", "");
}

static void show_message(Sheet *sheet, const LabBoard *board) {
    if (!board->message[0])
        return;
    sheet_text(sheet, STYLE_GOOD, 0, board->message);
    sheet_line(sheet, STYLE_PLAIN, "%s", "");
}

// Nothing could be drawn, so there are no points to show.
static bool is_broken(const LabVerdict *verdict) {
    return verdict->fault || verdict->status > LAB_FAILED;
}

static void show_title(Sheet *sheet, const LabBoard *board) {
    const Rubric *rubric = &board->rubrics[board->current];
    const LabVerdict *verdict = &board->verdict;
    char title[SHEET_WIDTH / 2], points[64], change[32] = "";
    if (!board->known || is_broken(verdict)) {
        sheet_wrapped(sheet, STYLE_BOLD, 0, "Lab %s: %s", rubric->id, rubric->title);
        return;
    }
    const double gained = verdict->score - board->score_before;
    if (board->score_before >= 0 && (gained >= 0.005 || gained <= -0.005))
        snprintf(change, sizeof change, "  (%+.3g)", gained);
    snprintf(title, sizeof title, "Lab %s: %s  ", rubric->id, rubric->title);
    snprintf(points, sizeof points, "%.0f of %.0f%s", round_down(verdict->score, 1), verdict->max_score,
             change);
    show_share(sheet, title, points, BAR, share(verdict->score, verdict->max_score));
}

static void show_checks(Sheet *sheet, const LabBoard *board) {
    const Rubric *rubric = &board->rubrics[board->current];
    const int name = within(sheet->columns - SHEET_MARK - 5 - POINTS, LEAST_NAME, NAME);
    for (int c = 0; c < board->verdict.check_count; c++) {
        const VerdictCheck *result = &board->verdict.checks[c];
        const Check *check = &rubric->checks[c];
        char points[16];
        sheet_marked(sheet, result->passed ? STYLE_GOOD : STYLE_BAD,
                     result->passed            ? "  ok   "
                     : c == board->focus.check ? "> open "
                                               : "  open ",
                     "%-5s %-*.*s %s of %d%s", check->task, name, name, check->name,
                     points_text(points, result->points), check->points,
                     check->optional ? " (optional)" : "");
    }
}

static void show_hints(Sheet *sheet, const LabBoard *board) {
    const Rubric *rubric = &board->rubrics[board->current];
    const int shown = lab_board_hints_shown(board);
    int count = 0;
    while (rubric_hint(rubric, board->focus.task, count))
        count++;
    for (int i = 0; i < shown; i++) {
        char text[2000];
        snprintf(text, sizeof text, "Hint %d of %d: %s", i + 1, count,
                 rubric_hint(rubric, board->focus.task, i));
        sheet_text(sheet, STYLE_PLAIN, 2, text);
    }
}

static void show_focus(Sheet *sheet, const LabBoard *board) {
    const Focus *focus = &board->focus;
    const VerdictCheck *check = &board->verdict.checks[focus->check];
    sheet_line(sheet, STYLE_PLAIN, "%s", "");
    sheet_wrapped(sheet, STYLE_BOLD, 0, "Task %s%s%s", focus->task, focus->place[0] ? "  " : "",
                  focus->place);
    const char *waiting = board->rubrics[board->current].checks[focus->check].task;
    if (check->undone && strchr(waiting, '.') && strcmp(waiting, focus->task) != 0)
        sheet_wrapped(sheet, STYLE_PLAIN, 2,
                      "The check of task %s shows nothing before this one is done, too.", waiting);
    else if (!check->undone || !focus->place[0])
        sheet_text(sheet, STYLE_BAD, 2, board->verdict.summary[0] ? board->verdict.summary : check->mistake);
    if (!check->undone && check->seen[0])
        sheet_text(sheet, STYLE_PLAIN, 2, check->seen);
    if (!check->undone)
        sheet_text(sheet, STYLE_PLAIN, 2, check->hint);
    show_hints(sheet, board);
}

// What compiler, driver or worker say.
static void show_words(Sheet *sheet, const LabBoard *board) {
    char folder[FILES_PATH];
    const LabVerdict *verdict = &board->verdict;
    if (!verdict->message[0] && !verdict->warnings[0])
        return;
    lab_board_lab_folder(board, board->current, folder);
    sheet_line(sheet, STYLE_PLAIN, "%s", "");
    sheet_wrapped(sheet, STYLE_DIM, 0, "in %s:", folder);
    sheet_text(sheet, STYLE_BAD, 2, verdict->message);
    sheet_text(sheet, STYLE_NOTE, 2, verdict->warnings);
}

void screens_lab(Sheet *sheet, const LabBoard *board, bool busy) {
    show_total(sheet, board);
    show_message(sheet, board);
    show_title(sheet, board);
    if (!board->known) {
        if (busy)
            sheet_line(sheet, STYLE_DIM, "  grading ...");
        return;
    }
    const bool broken = is_broken(&board->verdict);
    if (!broken)
        predict_first_show(sheet, board);
    if (board->verdict.done)
        after_lab_show_done(sheet, board);
    if (!broken && !board->verdict.done)
        show_checks(sheet, board);
    show_words(sheet, board);
    if (!broken && board->focus.check >= 0)
        show_focus(sheet, board);
    if (board->verdict.done) {
        after_lab_show(sheet, board, board->current);
        sheet_line(sheet, STYLE_PLAIN, "%s", "");
        show_checks(sheet, board);
    }
}

static void show_row(Sheet *sheet, const LabBoard *board, int lab, bool marked) {
    const Rubric *rubric = &board->rubrics[lab];
    const LabProgress *progress = progress_find(&board->progress, rubric->id);
    char bar[WIDE_BAR + 8], remark[64] = "not begun";
    const int title = within(sheet->columns - SHORT_REMARK, LEAST_NAME, TITLE);
    fit_bar(bar, sheet, title + LONG_REMARK, BAR, progress ? share(progress->score, progress->max_score) : 0);
    if (progress)
        snprintf(remark, sizeof remark, "%.0f of %.0f", round_down(progress->score, 1), progress->max_score);
    if (progress && progress->best > progress->score)
        snprintf(remark + strlen(remark), sizeof remark - strlen(remark), ", best %.0f",
                 round_down(progress->best, 1));
    if (progress && progress->done && progress->done_on[0])
        snprintf(remark + strlen(remark), sizeof remark - strlen(remark), ", done on %s", progress->done_on);
    sheet_marked(sheet, progress && progress->done ? STYLE_GOOD : STYLE_PLAIN, marked ? "> " : "  ",
                 "%s %-*.*s %s%s", rubric->id, title, title, rubric->title, bar, remark);
}

int screens_list(Sheet *sheet, const LabBoard *board, int marked) {
    show_total(sheet, board);
    const int first = sheet->count;
    for (int i = 0; i < board->lab_count; i++)
        show_row(sheet, board, i, i == marked);
    return first + marked;
}

void screens_footer(char *text, size_t size, const LabBoard *board, bool listing, bool busy) {
    if (listing)
        snprintf(text, size, "up, down, Enter: choose a lab   l back   q quit");
    else if (busy)
        snprintf(text, size, "h hint  l list  r run  n next  q quit     grading ...");
    else
        snprintf(text, size, "h hint  l list  r run  n next  q quit     graded at %s in %.1f s", board->clock,
                 board->verdict.seconds);
}
