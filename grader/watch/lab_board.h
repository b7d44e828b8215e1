// What the watch knows: the labs, how far each is, and which one is worked on.
#pragma once

#include "compile/afterword.h"
#include "watch/grading_process.h"
#include "grade/progress.h"

#include <stdbool.h>
#include <stdint.h>

enum { DESK_TEXT = 1000 };

// Where a student should look next.
typedef struct Focus {
    int check; // the first that failed; -1: none
    char task[16];
    char place[300]; // "labs/03-shadow-map/shadow.frag:17", where its TODO stands; "" when that is gone
    char left[300];  // where the TODO of an earlier task still stands; "" when none does
} Focus;

typedef struct LabBoard {
    const char *folder; // shaped like labs/
    Rubric rubrics[COURSE_MAX_LABS];
    Afterword afterwords[COURSE_MAX_LABS];
    int lab_count;
    Progress progress;
    int current;   // the lab that is worked on
    bool known;    // verdict and focus are there, and of this lab
    bool was_open; // an earlier verdict of this visit was not done
    LabVerdict verdict;
    double score_before; // the points before this verdict; -1 when there were none in this visit
    char clock[16];      // when the verdict came
    Focus focus;
    int hints[COURSE_MAX_LABS][EXAM_MAX_TASKS]; // of each task: how many are shown
    char message[DESK_TEXT];                    // for the next screen
} LabBoard;

// Reads the rubrics and the progress; takes the lab "03" first, or with NULL the first that is not done.
// False with a message; then `current` is below 0 when there is no such lab, and 0 when something cannot be
// read.
bool lab_board_create(LabBoard *board, const char *folder, const char *id);
void lab_board_destroy(LabBoard *board); // accepts a zeroed board

// Makes a lab the current one; its verdict is to come.
void lab_board_turn_to(LabBoard *board, int lab);

// The next lab after the current one that is not done, around the end; -1 when all others are.
int lab_board_next(const LabBoard *board);

// Takes a verdict for a lab of the board: records it and finds where to look. True when the current lab has
// just been done.
bool lab_board_take(LabBoard *board, const LabVerdict *verdict);

// Notes in the progress that a lab was put back to the skeleton: it has no points now. False with a message.
bool lab_board_begin_again(LabBoard *board, int lab);

// The folder of a lab's files.
void lab_board_lab_folder(const LabBoard *board, int lab, char folder[FILES_PATH]);

// Shows one more hint for the task in focus; a message when there is none left.
void lab_board_hint(LabBoard *board);

// The hints of the task in focus that are shown.
int lab_board_hints_shown(const LabBoard *board);

// Is the lab done, by its last grading?
bool lab_board_is_done(const LabBoard *board, int lab);

// The number of labs done.
int lab_board_done(const LabBoard *board);
// Points over all labs, of the last gradings.
double lab_board_score(const LabBoard *board);
double lab_board_max_score(const LabBoard *board);
