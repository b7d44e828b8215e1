#include "watch/after_lab.h"

#include "exam/handed_out.h"
#include "watch/after_points.h"

#include <string.h>

enum { PRINTED_WIDTH = 100 };

void after_lab_show_done(Sheet *sheet, const LabBoard *board) {
    const int next = lab_board_next(board);
    if (next < 0)
        sheet_wrapped(sheet, STYLE_GOOD, 2, "This lab is done, and all others are.");
    else
        sheet_wrapped(sheet, STYLE_GOOD, 2, "This lab is done. n goes on to lab %s: %s.",
                      board->rubrics[next].id, board->rubrics[next].title);
    sheet_wrapped(sheet, STYLE_PLAIN, 2, "`make hand-in LAB=%s` packs what you hand in.",
                  board->rubrics[board->current].id);
}

static void show_head(Sheet *sheet, const char *head) {
    sheet_line(sheet, STYLE_PLAIN, "%s", "");
    sheet_line(sheet, STYLE_BOLD, "%s", head);
}

// Each answer stands under what its question is about: the question itself stands in the handout.
static void show_answers(Sheet *sheet, const AfterwordAnswer *answers) {
    char text[AFTERWORD_MAX_ABOUT + 8];
    show_head(sheet, "The handout's three questions, answered");
    for (int q = 0; q < AFTERWORD_QUESTIONS; q++) {
        snprintf(text, sizeof text, "%d. %s", q + 1, answers[q].about);
        sheet_text(sheet, STYLE_BOLD, 2, text);
        for (int i = 0; i < answers[q].part_count; i++)
            sheet_text(sheet, STYLE_PLAIN, 5, answers[q].parts[i]);
    }
}

// Several parts are told apart by a dash.
static void show_parts(Sheet *sheet, const char *head, const char *const *parts, int count) {
    char text[AFTERWORD_MAX_TEXT + 4];
    show_head(sheet, head);
    for (int i = 0; i < count; i++) {
        snprintf(text, sizeof text, "%s%s", count > 1 ? "- " : "", parts[i]);
        sheet_text(sheet, STYLE_PLAIN, 2, text);
    }
}

void after_lab_show(Sheet *sheet, const LabBoard *board, int lab) {
    const Afterword *afterword = &board->afterwords[lab];
    char folder[FILES_PATH];
    lab_board_lab_folder(board, lab, folder);
    if (afterword->idea) {
        show_parts(sheet, "The idea", &afterword->idea, 1);
        show_answers(sheet, afterword->answers);
        after_points_show(sheet, &board->rubrics[lab], folder);
        show_parts(sheet, "To try in the window (r)", afterword->tries, afterword->try_count);
        show_parts(sheet, "Another way", &afterword->other_way, 1);
    }
    if (!handed_out_alone())
        sheet_wrapped(sheet, STYLE_PLAIN, 2, "Our solution, to compare: solutions/%s",
                      strrchr(board->rubrics[lab].folder, '/') + 1);
    show_head(sheet, "Your pictures");
    sheet_wrapped(sheet, STYLE_PLAIN, 2, "`make showcase` draws all your labs and puts them on one page.");
}

bool after_lab_print(const LabBoard *board, bool color) {
    static Sheet sheet;
    const char *id = board->rubrics[board->current].id;
    const bool done = lab_board_is_done(board, board->current);
    sheet_begin(&sheet, PRINTED_WIDTH);
    if (done)
        after_lab_show(&sheet, board, board->current);
    else
        sheet_wrapped(&sheet, STYLE_PLAIN, 0, "Lab %s is not done yet; `make watch LAB=%s` goes on.", id, id);
    sheet_print(&sheet, stdout, color);
    return done;
}
