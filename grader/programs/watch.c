// watch: grades a lab whenever one of its files is saved, and says what to do next. See
// grader/watch/README.md.
#include "base/file_watch.h"
#include "scene/check.h"
#include "base/color.h"
#include "base/command_line.h"
#include "base/option_values.h"
#include "base/places.h"
#include "exam/exam_seeds.h"
#include "watch/after_lab.h"
#include "watch/predict_first.h"
#include "watch/screens.h"
#include "watch/terminal.h"
#include "watch/viewer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_DONE, EXIT_OPEN, EXIT_FAULT = 3, LOOK_EVERY = 40, PLAIN_WIDTH = 100, SCROLL = 4 };

typedef struct Watch {
    LabBoard board;
    GradingProcess grading;
    Viewer viewer;
    FileWatch changes[COURSE_MAX_LABS];
    bool entered; // the current lab was just chosen, and is to be graded
    bool listing, dirty, end;
    int marked;        // in the list
    int top, list_top; // the first lines of the lab's screen and of the list that are shown
    bool color;
} Watch;

typedef struct WatchCommand {
    char folder[FILES_PATH], lab[3]; // "": the first that is not done
    GradingOptions grading;
    bool list, answer, predict, begin_again;
} WatchCommand;

#define AT(field) offsetof(WatchCommand, field)
static const Option options[] = {
    {"lab", 0, "NN", "begin with this lab (default: the first that is not done)", AT(lab), option_lab},
    {"seed", 0, "N", "of all gradings (default: drawn at the start, and kept)", AT(grading.seed),
     option_seed},
    {"context", 0, "C", "osmesa or egl (default: the first that is here); also SHADOW_LAB_CONTEXT",
     AT(grading.context), option_context},
    {"list", 0, NULL, "print how far all labs are, and end", AT(list), option_flag},
    {"answer", 0, NULL, "print what a lab that is done has to tell, and end", AT(answer), option_flag},
    {"predict", 0, NULL, "write the questions of a lab's predictions, with numbers of your own, and end",
     AT(predict), option_flag},
    {"begin-again", 0, NULL, "note that the lab is not done, and end", AT(begin_again), option_flag},
    {0}};
#undef AT

static bool check(void *settings, const Operands *operands) {
    WatchCommand *command = settings;
    if ((command->answer || command->predict || command->begin_again) && !command->lab[0])
        return check_fail("--answer, --predict and --begin-again go with --lab NN");
    return operands->count == 0 || realpath(operands->texts[0], command->folder) ||
           check_fail("%s is not a folder", operands->texts[0]);
}

static const CommandLine command_line = {
    .program = "watch",
    .forms = "[options] [FOLDER]",
    .about =
        "Grades a lab whenever one of its files is saved. FOLDER is shaped like labs/ (default: labs).\n",
    .options = options,
    .ending = "exit status: 0 or, without a terminal, 1 when the lab is not done; 2 usage, 3 a fault\n",
    .operand = "FOLDER",
    .most = 1,
    .check = check,
};

static void ask(Watch *watch) {
    watch->entered = false;
    watch->dirty = true;
    if (grading_process_ask(&watch->grading, watch->board.current))
        return;
    snprintf(watch->board.message, sizeof watch->board.message, "%s", check_message());
    check_clear();
}

static void begin_changes(Watch *watch, int lab) {
    char folder[FILES_PATH];
    lab_board_lab_folder(&watch->board, lab, folder);
    file_watch_begin(&watch->changes[lab], folder, "");
}

static void turn_to(Watch *watch, int lab) {
    lab_board_turn_to(&watch->board, lab);
    watch->listing = false;
    watch->top = 0;
    watch->entered = watch->dirty = true;
    predict_first_draw(&watch->board, lab);
    begin_changes(watch, lab); // the questions that were just drawn are no save of a student
}

// Grades the current lab when it was saved or just chosen. Another lab that is saved becomes the current
// one; several at once are not a student's doing (git is at work) and change nothing.
static void look(Watch *watch) {
    bool own = watch->entered;
    int others = 0, other = -1;
    if (watch->grading.busy)
        return;
    for (int lab = 0; lab < watch->board.lab_count; lab++) {
        const bool saved = file_watch_found(&watch->changes[lab]);
        if (lab == watch->board.current)
            own = own || saved;
        else if (saved && ++others > 0)
            other = lab;
    }
    check_clear();
    if (!own && others != 1)
        return;
    if (!watch->entered) // else the message says why we are here
        watch->board.message[0] = '\0';
    if (!own)
        turn_to(watch, other);
    ask(watch);
}

static void go_on(Watch *watch) {
    LabBoard *board = &watch->board;
    const int next = lab_board_next(board);
    if (next < 0)
        snprintf(board->message, sizeof board->message, "there is no other lab that is not done");
    else
        turn_to(watch, next);
}

static void take_verdict(Watch *watch) {
    LabBoard *board = &watch->board;
    watch->dirty = true;
    if (!grading_process_take(&watch->grading))
        return;
    if (lab_board_take(board, &watch->grading.verdict))
        snprintf(board->message, sizeof board->message, "Lab %s is done: %.0f of %.0f points.%s",
                 board->rubrics[board->current].id, board->verdict.score, board->verdict.max_score,
                 lab_board_next(board) < 0 ? " All labs are done!" : "");
    watch->top = 0;
}

static void press_in_list(Watch *watch, int key) {
    const int count = watch->board.lab_count;
    if (key == KEY_UP || key == 'k')
        watch->marked = (watch->marked + count - 1) % count;
    else if (key == KEY_DOWN || key == 'j')
        watch->marked = (watch->marked + 1) % count;
    else if (key == KEY_ENTER)
        turn_to(watch, watch->marked);
    else if (key == 'l' || key == KEY_ESCAPE)
        watch->listing = false;
}

static void press_in_lab(Watch *watch, int key) {
    LabBoard *board = &watch->board;
    if (key == 'h')
        lab_board_hint(board);
    else if (key == 'n')
        go_on(watch);
    else if (key == 'r')
        viewer_open(&watch->viewer, board);
    else if (key == KEY_DOWN || key == KEY_UP)
        watch->top += key == KEY_DOWN ? SCROLL : -SCROLL;
    else if (key == 'l') {
        watch->listing = true;
        watch->marked = board->current;
    }
}

static void press(Watch *watch, int key) {
    watch->dirty = true;
    if (key != KEY_DOWN && key != KEY_UP)
        watch->board.message[0] = '\0';
    if (key == 'q')
        watch->end = true;
    else if (watch->listing)
        press_in_list(watch, key);
    else
        press_in_lab(watch, key);
}

static void draw(Watch *watch) {
    static Sheet sheet;
    char footer[200];
    int columns, rows;
    terminal_size(&columns, &rows);
    sheet_begin(&sheet, columns);
    int *top = watch->listing ? &watch->list_top : &watch->top;
    if (watch->listing)
        *top = sheet_top_with(&sheet, screens_list(&sheet, &watch->board, watch->marked), *top, rows);
    else
        screens_lab(&sheet, &watch->board, watch->grading.busy);
    const int last = sheet_last_top(&sheet, rows);
    *top = *top > last ? last : *top < 0 ? 0 : *top;
    screens_footer(footer, sizeof footer, &watch->board, watch->listing, watch->grading.busy);
    sheet_show(&sheet, *top, footer, columns, rows, watch->color);
    watch->dirty = false;
}

static void watch_terminal(Watch *watch) {
    for (int lab = 0; lab < watch->board.lab_count; lab++)
        begin_changes(watch, lab);
    turn_to(watch, watch->board.current);
    while (!watch->end) {
        look(watch);
        if (viewer_failed(&watch->viewer, watch->board.message, sizeof watch->board.message))
            watch->dirty = true;
        if (watch->dirty)
            draw(watch);
        const Event event = terminal_wait(watch->grading.busy ? watch->grading.verdicts : -1, LOOK_EVERY);
        watch->end = event.end;
        watch->dirty = watch->dirty || event.redraw;
        if (event.readable)
            take_verdict(watch);
        if (event.key != KEY_NONE)
            press(watch, event.key);
    }
}

// Without a terminal: one grading, in plain lines.
static void print_once(Watch *watch) {
    static Sheet sheet;
    ask(watch);
    while (watch->grading.busy)
        grading_process_take(&watch->grading);
    lab_board_take(&watch->board, &watch->grading.verdict);
    sheet_begin(&sheet, PLAIN_WIDTH);
    screens_lab(&sheet, &watch->board, false);
    sheet_print(&sheet, stdout, false);
}

static void print_list(Watch *watch) {
    static Sheet sheet;
    sheet_begin(&sheet, PLAIN_WIDTH);
    (void)screens_list(&sheet, &watch->board, -1);
    sheet_print(&sheet, stdout, watch->color);
    if (watch->board.message[0])
        printf("\n%s\n", watch->board.message);
}

static int run(Watch *watch, const WatchCommand *command) {
    if (command->begin_again)
        return lab_board_begin_again(&watch->board, watch->board.current) ? EXIT_DONE : EXIT_FAULT;
    if (command->answer)
        return after_lab_print(&watch->board, watch->color) ? EXIT_DONE : EXIT_OPEN;
    if (command->predict)
        return predict_first_print(&watch->board) ? EXIT_DONE : EXIT_FAULT;
    if (command->list) {
        print_list(watch);
        return EXIT_DONE;
    }
    if (terminal_open()) {
        watch_terminal(watch);
        grading_process_stop(&watch->grading);
        terminal_close();
        printf("%.0f of %.0f points; `make watch` goes on\n", lab_board_score(&watch->board),
               lab_board_max_score(&watch->board));
        return EXIT_DONE;
    }
    char why[200];
    snprintf(why, sizeof why, "%.199s", check_message());
    print_once(watch);
    printf("\nwatch: %s.\nRun `make watch` in a terminal, or `make grade LAB=%s` after each change.\n", why,
           watch->board.rubrics[watch->board.current].id);
    return watch->board.verdict.fault ? EXIT_FAULT : watch->board.verdict.done ? EXIT_DONE : EXIT_OPEN;
}

static bool begin(WatchCommand *command) {
    command->grading.seconds = 20;
    places_path(command->folder, "labs");
    return exam_seeds_draw(&command->grading.seed);
}

int main(int count, char **arguments) {
    static Watch watch;
    static WatchCommand command;
    if (!begin(&command)) {
        command_line_complain(&command_line, check_message());
        return EXIT_USAGE;
    }
    command_line_take(&command_line, &command, count, arguments);
    if (!command.list && !command.answer && !command.begin_again)
        command_line_settle_context(&command_line, &command.grading.context);
    if (!lab_board_create(&watch.board, command.folder, command.lab[0] ? command.lab : NULL)) {
        fprintf(stderr, "watch: %s\n", check_message());
        lab_board_destroy(&watch.board);
        return watch.board.current < 0 ? EXIT_USAGE : EXIT_FAULT;
    }
    command.grading.folder = command.folder;
    command.grading.rubrics = watch.board.rubrics;
    watch.grading.options = command.grading;
    watch.color = color_wanted(stdout);
    const int status = run(&watch, &command);
    grading_process_stop(&watch.grading);
    lab_board_destroy(&watch.board);
    return status;
}
