// What a student's predictions are worth. They count points, and a lab passes without them.
#pragma once

#include "compile/rubric.h"
#include "predict/prediction.h"
#include "predict/prediction_file.h"

#include <stdbool.h>

typedef struct PredictionResult {
    int points; // that it is worth
    bool right;
    char typed[PREDICTION_NUMBER];      // "" while nothing is
    char question[PREDICTION_QUESTION]; // with its numbers; "" without a sheet
    char why[1000];                     // what is wrong and what helps; "" when it is right
} PredictionResult;

typedef struct Predictions {
    int count;  // of the lab; 0: it has none
    long sheet; // of the submission; 0: none
    PredictionResult results[RUBRIC_MAX_PREDICTIONS];
    bool undrawn;                     // the file lies there as it was handed out
    char message[PREDICTION_MESSAGE]; // of the file as a whole; "" when nothing is wrong with it
} Predictions;

// Does the rubric give points for as many predictions as the lab brings along? False with a message.
bool predictions_fit(const Rubric *rubric);

// Those of the rubric, with nothing handed in.
void predictions_begin(Predictions *predictions, const Rubric *rubric);

// Judges what the folder of a submission holds; whatever is wrong with the file is told in `predictions`.
// False with a message when the machine is to blame.
bool predictions_take(Predictions *predictions, const Rubric *rubric, const char *folder);

// Takes the verdict back, for a lab that cannot be graded as a whole: no points, and that this is why.
void predictions_put_off(Predictions *predictions);

// The points of those that are right.
int predictions_points(const Predictions *predictions);

// The points of all.
int predictions_max_points(const Predictions *predictions);

// Is a number still to be typed? (Also where the file is missing.)
bool predictions_open(const Predictions *predictions);
