#include "watch/lab_board.h"

#include "scene/check.h"
#include "base/places.h"
#include "watch/todo.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void add_lab(const char *id, void *context) {
    Desk *desk = context;
    char folder[FILES_PATH];
    if (desk->lab_count < RESULT_MAX_LABS && home_find_lab(folder, id) &&
        rubric_load(&desk->rubrics[desk->lab_count], folder))
        desk->lab_count++;
}

static bool is_done(const Desk *desk, int lab) {
    const LabProgress *progress = progress_find(&desk->progress, desk->rubrics[lab].id);
    return progress && progress->done;
}

int desk_next(const Desk *desk) {
    for (int i = 1; i < desk->lab_count; i++) {
        const int lab = (desk->current + i) % desk->lab_count;
        if (!is_done(desk, lab))
            return lab;
    }
    return -1;
}

static int find_lab(const Desk *desk, const char *id) {
    for (int i = 0; i < desk->lab_count; i++)
        if (strcmp(desk->rubrics[i].id, id) == 0)
            return i;
    return -1;
}

bool desk_create(Desk *desk, const char *folder, const char *id) {
    *desk = (Desk){.folder = folder};
    if (!home_list_labs(add_lab, desk) || check_message()[0] || !progress_load(&desk->progress))
        return false;
    snprintf(desk->message, sizeof desk->message, "%s", desk->progress.note);
    int lab = id ? find_lab(desk, id) : 0;
    if (lab < 0)
        return check_fail("there is no lab \"%s\"; give two digits as in labs/, for instance LAB=02", id);
    desk_turn_to(desk, lab);
    if (!id && is_done(desk, lab) && desk_next(desk) >= 0)
        desk_turn_to(desk, desk_next(desk));
    return true;
}

void desk_destroy(Desk *desk) {
    for (int i = 0; i < desk->lab_count; i++)
        rubric_destroy(&desk->rubrics[i]);
    desk->lab_count = 0;
}

void desk_turn_to(Desk *desk, int lab) {
    desk->current = lab;
    desk->known = desk->was_open = false;
    desk->score_before = -1;
}

void desk_lab_folder(const Desk *desk, int lab, char folder[FILES_PATH]) {
    const char *name = strrchr(desk->rubrics[lab].folder, '/') + 1;
    if (!home_find_lab_in(folder, desk->folder, desk->rubrics[lab].id))
        files_join(folder, desk->folder, name);
    check_clear();
}

// The task's place in its lab, from 1; 0 for a check about the whole lab.
static int task_number(const char *task) {
    const char *dot = strchr(task, '.');
    const int number = dot ? atoi(dot + 1) : 0;
    return number < DESK_MAX_TASKS ? number : 0;
}

static bool find_todo(const Desk *desk, const char *task, char *place, size_t size) {
    char folder[FILES_PATH], inside[160];
    desk_lab_folder(desk, desk->current, folder);
    if (!todo_find(&desk->rubrics[desk->current], folder, task, inside, sizeof inside))
        return false;
    snprintf(place, size, "%s/%s/%s",
             strrchr(desk->folder, '/') ? strrchr(desk->folder, '/') + 1 : desk->folder,
             strrchr(folder, '/') + 1, inside);
    return true;
}

// A task that is said to be open may be done already and show only together with a later one: then its TODO
// is gone, and the next TODO is where to go on. An earlier TODO may be forgotten, or a task that was skipped.
static void find_open_task(const Desk *desk, Focus *focus) {
    char task[16], place[300];
    const int lab = atoi(desk->rubrics[desk->current].id), said = task_number(focus->task);
    for (int n = 1; n < DESK_MAX_TASKS; n++) {
        snprintf(task, sizeof task, "%d.%d", lab, n);
        if (!find_todo(desk, task, place, sizeof place))
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

static void find_focus(Desk *desk) {
    const Rubric *rubric = &desk->rubrics[desk->current];
    Focus *focus = &desk->focus;
    *focus = (Focus){.check = -1};
    for (int pass = 0; pass < 2 && focus->check < 0; pass++) // optional checks come last
        for (int c = desk->verdict.check_count - 1; c >= 0; c--)
            if (!desk->verdict.checks[c].passed && rubric->checks[c].optional == (pass == 1))
                focus->check = c;
    if (focus->check < 0)
        return;
    const VerdictCheck *check = &desk->verdict.checks[focus->check];
    snprintf(focus->task, sizeof focus->task, "%s", check->task);
    if (check->undone)
        find_open_task(desk, focus);
    else
        find_todo(desk, focus->task, focus->place, sizeof focus->place);
}

static bool record(Desk *desk, const Verdict *verdict) {
    if (verdict->fault || verdict->status > LAB_FAILED) // it does not compile just now: that is no step back
        return true;
    return progress_record(&desk->progress, desk->rubrics[verdict->lab].id, verdict->score,
                           verdict->max_score, verdict->done);
}

bool desk_take(Desk *desk, const Verdict *verdict) {
    if (!record(desk, verdict))
        snprintf(desk->message, sizeof desk->message, "%s", check_message());
    check_clear();
    if (verdict->lab != desk->current)
        return false;
    const bool just_done = verdict->done && desk->was_open;
    const time_t now = time(NULL);
    if (desk->known && desk->verdict.status <= LAB_FAILED)
        desk->score_before = desk->verdict.score;
    desk->verdict = *verdict;
    desk->known = true;
    desk->was_open = desk->was_open || !verdict->done;
    strftime(desk->clock, sizeof desk->clock, "%H:%M:%S", localtime(&now));
    find_focus(desk);
    return just_done;
}

static int hint_count(const Desk *desk) {
    int count = 0;
    while (rubric_hint(&desk->rubrics[desk->current], desk->focus.task, count))
        count++;
    return count;
}

// For a task that is not begun the first hint stands there from the start.
int desk_hints_shown(const Desk *desk) {
    if (!desk->known || desk->focus.check < 0)
        return 0;
    const int asked = desk->hints[desk->current][task_number(desk->focus.task)];
    const int shown = asked + desk->verdict.checks[desk->focus.check].undone;
    return shown < hint_count(desk) ? shown : hint_count(desk);
}

void desk_hint(Desk *desk) {
    const Rubric *rubric = &desk->rubrics[desk->current];
    if (!desk->known || desk->focus.check < 0)
        snprintf(desk->message, sizeof desk->message, "there is nothing to hint at");
    else if (desk_hints_shown(desk) < hint_count(desk))
        desk->hints[desk->current][task_number(desk->focus.task)]++;
    else
        snprintf(desk->message, sizeof desk->message, "no more hints; the handout is %s/%s/README.md",
                 desk->folder, strrchr(rubric->folder, '/') + 1);
}

int desk_done(const Desk *desk) {
    int count = 0;
    for (int i = 0; i < desk->lab_count; i++)
        count += is_done(desk, i);
    return count;
}

double desk_score(const Desk *desk) {
    double score = 0;
    for (int i = 0; i < desk->lab_count; i++) {
        const LabProgress *lab = progress_find(&desk->progress, desk->rubrics[i].id);
        score += lab ? lab->score : 0;
    }
    return score;
}

double desk_max_score(const Desk *desk) {
    double score = 0;
    for (int i = 0; i < desk->lab_count; i++)
        score += rubric_points(&desk->rubrics[i]);
    return score;
}
