// Takes verdicts and decides what to show: which lab, which open task, where its TODO stands, how many hints.
#include "watch/lab_board.h"

#include "scene/check.h"
#include "compile/rubric_file.h"
#include "base/places.h"
#include "compile/todo.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void add_lab(const char *id, void *context) {
    LabBoard *board = context;
    char folder[FILES_PATH];
    if (board->lab_count == COURSE_MAX_LABS)
        check_fail("there are more than %d labs", COURSE_MAX_LABS);
    else if (!check_message()[0] && places_find_lab(folder, id) &&
             rubric_load(&board->rubrics[board->lab_count], folder)) {
        const int lab = board->lab_count++;
        afterword_load(&board->afterwords[lab], &board->rubrics[lab]);
    }
}

bool lab_board_is_done(const LabBoard *board, int lab) {
    const LabProgress *progress = progress_find(&board->progress, board->rubrics[lab].id);
    return progress && progress->done;
}

int lab_board_next(const LabBoard *board) {
    for (int i = 1; i < board->lab_count; i++) {
        const int lab = (board->current + i) % board->lab_count;
        if (!lab_board_is_done(board, lab))
            return lab;
    }
    return -1;
}

static int find_lab(const LabBoard *board, const char *id) {
    for (int i = 0; i < board->lab_count; i++)
        if (strcmp(board->rubrics[i].id, id) == 0)
            return i;
    return -1;
}

bool lab_board_create(LabBoard *board, const char *folder, const char *id) {
    *board = (LabBoard){.folder = folder};
    if (!places_list_labs(add_lab, board) || check_message()[0] || !progress_load(&board->progress))
        return false;
    snprintf(board->message, sizeof board->message, "%s", board->progress.note);
    int lab = id ? find_lab(board, id) : 0;
    board->current = lab;
    if (lab < 0)
        return check_fail("there is no lab \"%s\"; give two digits as in labs/, for instance LAB=02", id);
    lab_board_turn_to(board, lab);
    if (!id && lab_board_is_done(board, lab) && lab_board_next(board) >= 0)
        lab_board_turn_to(board, lab_board_next(board));
    return true;
}

void lab_board_destroy(LabBoard *board) {
    for (int i = 0; i < board->lab_count; i++) {
        rubric_destroy(&board->rubrics[i]);
        afterword_destroy(&board->afterwords[i]);
    }
    board->lab_count = 0;
}

void lab_board_turn_to(LabBoard *board, int lab) {
    board->current = lab;
    board->known = board->was_open = false;
    board->score_before = -1;
}

void lab_board_lab_folder(const LabBoard *board, int lab, char folder[FILES_PATH]) {
    const char *name = strrchr(board->rubrics[lab].folder, '/') + 1;
    if (!places_find_lab_in(folder, board->folder, board->rubrics[lab].id))
        files_join(folder, board->folder, name);
    check_clear();
}

// The task's place in its lab, from 1; 0 for a check about the whole lab.
static int task_number(const char *task) {
    const char *dot = strchr(task, '.');
    const int number = dot ? atoi(dot + 1) : 0;
    return number < EXAM_MAX_TASKS ? number : 0;
}

static bool find_todo(const LabBoard *board, const char *task, char *place, size_t size) {
    char folder[FILES_PATH], inside[160];
    lab_board_lab_folder(board, board->current, folder);
    if (!todo_find(&board->rubrics[board->current], folder, task, inside, sizeof inside))
        return false;
    snprintf(place, size, "%s/%s/%s",
             strrchr(board->folder, '/') ? strrchr(board->folder, '/') + 1 : board->folder,
             strrchr(folder, '/') + 1, inside);
    return true;
}

// A task that is said to be open may be done already and show only together with a later one: then its TODO
// is gone, and the next TODO is where to go on. An earlier TODO may be forgotten, or a task that was skipped.
static void find_open_task(const LabBoard *board, Focus *focus) {
    char task[16], place[300];
    const int lab = atoi(board->rubrics[board->current].id), said = task_number(focus->task);
    for (int n = 1; n < EXAM_MAX_TASKS; n++) {
        snprintf(task, sizeof task, "%d.%d", lab, n);
        if (!find_todo(board, task, place, sizeof place))
            continue;
        if (n < said && !focus->left[0])
            memcpy(focus->left, place, sizeof place);
        if (n < said)
            continue;
        memcpy(focus->task, task, sizeof task);
        memcpy(focus->place, place, sizeof place);
        return;
    }
}

static void find_focus(LabBoard *board) {
    const Rubric *rubric = &board->rubrics[board->current];
    Focus *focus = &board->focus;
    *focus = (Focus){.check = -1};
    for (int pass = 0; pass < 2 && focus->check < 0; pass++) // optional checks come last
        for (int c = board->verdict.check_count - 1; c >= 0; c--)
            if (!board->verdict.checks[c].passed && rubric->checks[c].optional == (pass == 1))
                focus->check = c;
    if (focus->check < 0)
        return;
    const VerdictCheck *check = &board->verdict.checks[focus->check];
    snprintf(focus->task, sizeof focus->task, "%s", check->task);
    if (check->undone)
        find_open_task(board, focus);
    else
        find_todo(board, focus->task, focus->place, sizeof focus->place);
}

static bool record(LabBoard *board, const LabVerdict *verdict) {
    const Rubric *rubric = &board->rubrics[verdict->lab];
    MistakesMet met = {0};
    if (verdict->fault || verdict->status > LAB_FAILED) // it does not compile just now: that is no step back
        return true;
    for (int c = 0; c < verdict->check_count; c++)
        if (!verdict->checks[c].passed && !verdict->checks[c].undone)
            mistakes_met_add(&met, rubric, verdict->checks[c].mistake);
    return progress_record(&board->progress, rubric->id, verdict->score, verdict->max_score, verdict->done,
                           &met);
}

bool lab_board_begin_again(LabBoard *board, int lab) {
    const Rubric *rubric = &board->rubrics[lab];
    return !progress_find(&board->progress, rubric->id) ||
           progress_record(&board->progress, rubric->id, 0, rubric_points(rubric), false, NULL);
}

bool lab_board_take(LabBoard *board, const LabVerdict *verdict) {
    if (!record(board, verdict))
        snprintf(board->message, sizeof board->message, "%s", check_message());
    check_clear();
    if (verdict->lab != board->current)
        return false;
    const bool just_done = verdict->done && board->was_open;
    const time_t now = time(NULL);
    if (board->known && board->verdict.status <= LAB_FAILED)
        board->score_before = board->verdict.score;
    board->verdict = *verdict;
    board->known = true;
    board->was_open = board->was_open || !verdict->done;
    strftime(board->clock, sizeof board->clock, "%H:%M:%S", localtime(&now));
    find_focus(board);
    return just_done;
}

static int hint_count(const LabBoard *board) {
    int count = 0;
    while (rubric_hint(&board->rubrics[board->current], board->focus.task, count))
        count++;
    return count;
}

// For a task that is not begun the first hint stands there from the start.
int lab_board_hints_shown(const LabBoard *board) {
    if (!board->known || board->focus.check < 0)
        return 0;
    const int asked = board->hints[board->current][task_number(board->focus.task)];
    const int shown = asked + board->verdict.checks[board->focus.check].undone;
    return shown < hint_count(board) ? shown : hint_count(board);
}

void lab_board_hint(LabBoard *board) {
    const Rubric *rubric = &board->rubrics[board->current];
    if (!board->known || board->focus.check < 0)
        snprintf(board->message, sizeof board->message, "there is nothing to hint at");
    else if (lab_board_hints_shown(board) < hint_count(board))
        board->hints[board->current][task_number(board->focus.task)]++;
    else
        snprintf(board->message, sizeof board->message, "no more hints; the handout is %s/%s/README.md",
                 board->folder, strrchr(rubric->folder, '/') + 1);
}

int lab_board_done(const LabBoard *board) {
    int count = 0;
    for (int i = 0; i < board->lab_count; i++)
        count += lab_board_is_done(board, i);
    return count;
}

double lab_board_score(const LabBoard *board) {
    double score = 0;
    for (int i = 0; i < board->lab_count; i++) {
        const LabProgress *lab = progress_find(&board->progress, board->rubrics[i].id);
        score += lab ? lab->score : 0;
    }
    return score;
}

double lab_board_max_score(const LabBoard *board) {
    double score = 0;
    for (int i = 0; i < board->lab_count; i++)
        score += rubric_points(&board->rubrics[i]);
    return score;
}
