// A row of the stability suite: one method swept to where it breaks, and what must come out.
//
// Interface: a lab defines Rows in a table; row_list lists those of all labs, row_run runs and judges one. A
// row's function makes its figures by findings_figure and curve.h, and keeps bad frames by findings_frame.
#pragma once

#include "stability/lab_set.h"
#include "stability/curve.h"
#include "stability/reel.h"
#include "study/truth_view.h"

#include <stdbool.h>

enum { ROW_MOST = 128, ROW_FIGURES = 3, ROW_FRAMES = 3, ROW_TEXT = 600 };

typedef struct RowFrame {
    char caption[ROW_TEXT];
    double badness;
    Image strip; // owned; see strip.h
} RowFrame;

typedef struct Findings {
    Figure figures[ROW_FIGURES];
    int figure_count;
    RowFrame frames[ROW_FRAMES]; // the worst
    Reel reel;                   // all
} Findings;

// Texts for people; `expected` says what comes out and why. A curve whose name begins with "failure" and that
// is to equal something must be expected to differ from 0 somewhere, or the row fails.
typedef struct Row {
    int number; // no other row has it; those of a new lab NN are NN01, NN02, ...: 100 * LAB_NUMBER + 1
    const char *name, *method, *sweep, *expected, *source;
    // Fills the findings. False with a message when something could not be drawn. NULL: no lab has the method
    // yet; `expected` then says what would be seen.
    bool (*run)(LabSet *labs, Findings *findings);
} Row;

// The rows of all labs, then NULL. Each solutions/NN-name/rows*.c that has some defines a table of them,
// which ends with the number 0, by the name LAB_TABLE; build.mk makes this list.
extern const Row *const rows_tables[];

// All rows in the order of their numbers, at most ROW_MOST; returns how many there are. Aborts when two have
// the same number.
int row_list(const Row *rows[ROW_MOST]);

// A new figure without curves. Abort when there is no room.
Figure *findings_figure(Findings *findings, const char *title, const char *x_label, const char *y_label);

// Adds the frame to the reel, and keeps it in `slot` (0..ROW_FRAMES - 1) when it is worse than the one kept
// there: where sweeps go on, the worst stays.
void findings_frame(Findings *findings, int slot, double badness, const TruthView *truth_view,
                    const Measured *measured, const char *caption, ...) __attribute__((format(printf, 6, 7)));

void findings_destroy(Findings *findings); // accepts zeroed findings

typedef enum RowStatus { ROW_PASS, ROW_FAIL, ROW_NOT_BUILT } RowStatus;

// A row that ran.
typedef struct RowResult {
    const Row *row;
    Findings findings;
    char message[ROW_TEXT]; // why it could not go on; "" when it could
    RowStatus status;       // it passes when it could go on, there are curves and all of them hold
    CurveVerdict worst;     // what uses up most of its tolerance
    const Curve *curve;     // that it belongs to; NULL: there are none
    int objects;            // the most of a scene of the row
} RowResult;

// Runs the row and judges it. The caller destroys the findings.
void row_run(RowResult *result, const Row *row, LabSet *labs);
const char *row_status_name(RowStatus status); // "pass", "fail", "not-built"
