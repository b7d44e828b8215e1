// A row of the stability suite: one method swept to where it breaks, and what must come out.
#pragma once

#include "stability/lab_set.h"
#include "stability/curve.h"
#include "study/truth_view.h"

#include <stdbool.h>

enum { ROW_COUNT = 31, ROW_FIGURES = 3, ROW_FRAMES = 3, ROW_TEXT = 600 };

typedef struct RowFrame {
    char caption[ROW_TEXT];
    double badness;
    Image strip; // owned; see strip.h
} RowFrame;

typedef struct Findings {
    Figure figures[ROW_FIGURES];
    int figure_count;
    RowFrame frames[ROW_FRAMES];
} Findings;

// Texts for people; `expected` says what comes out and why.
typedef struct Row {
    int number; // as in the suite's list, 1..ROW_COUNT
    const char *name, *method, *sweep, *expected, *source;
    // Fills the findings. False with a message when something could not be drawn. NULL: no lab has the method
    // yet; `expected` then says what would be seen.
    bool (*run)(LabSet *labs, Findings *findings);
} Row;

// The rows, a list for each topic; ends with the number 0.
extern const Row rows_bias[];       // rows_bias.c: acne and its cures
extern const Row rows_kernel[];     // rows_kernel.c: what a wide filter needs
extern const Row rows_contact[];    // rows_contact.c: what the cures cost
extern const Row rows_frame[];      // rows_frame.c: where the map ends
extern const Row rows_depth[];      // rows_depth.c: how many bits a depth needs
extern const Row rows_resolution[]; // rows_resolution.c: the size of a texel
extern const Row rows_filter[];     // rows_filter.c: soft edges
extern const Row rows_early_out[];  // rows_early_out.c: what an early-out misses
extern const Row rows_motion[];     // rows_motion.c: a shadow map that moves
extern const Row rows_planes[];     // rows_planes.c: what cuts shadow volumes
extern const Row rows_closed[];     // rows_closed.c: what a volume needs of its caster
extern const Row rows_stencil[];    // rows_stencil.c: how far eight bits of stencil count
extern const Row rows_fill[];       // rows_fill.c: what counting costs
extern const Row rows_bake[];       // rows_bake.c: ambient occlusion by rays
extern const Row rows_screen[];     // rows_screen.c: ambient occlusion from the picture
extern const Row rows_later[];      // rows_later.c: methods that no lab has yet

// The row with this number; NULL when there is none.
const Row *row_find(int number);

// A new figure without curves. Abort when there is no room.
Figure *findings_figure(Findings *findings, const char *title, const char *x_label, const char *y_label);

// Keeps the frame in `slot` (0..ROW_FRAMES - 1) when it is worse than the one kept there: where sweeps go on,
// the worst stays.
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
} RowResult;

// Runs the row and judges it. The caller destroys the findings.
void row_run(RowResult *result, const Row *row, LabSet *labs);
const char *row_status_name(RowStatus status); // "pass", "fail", "not-built"
