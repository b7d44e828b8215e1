// A number that a student works out before the lab runs for the first time, by the handout's mathematics. A
// lab brings its predictions along in solutions/NN-name/predictions*.c; their points stand in its
// rubric.json.
#pragma once

#include <stddef.h>

enum { PREDICTION_MAX_GIVEN = 4, PREDICTION_QUESTION = 600 };

// A number that the question gives: low, low + step, ... up to low + (count - 1) step.
typedef struct PredictionGiven {
    const char *name; // stands in the question as {name}
    double low, step;
    int count;
} PredictionGiven;

typedef struct Prediction {
    const char *lab;      // LAB_ID
    const char *question; // with {name} for each number that is given
    const char *hint;     // told to who typed another number
    PredictionGiven given[PREDICTION_MAX_GIVEN];
    double (*answer)(const double given[PREDICTION_MAX_GIVEN]); // the closed form
    double tolerance; // what is right may differ from it by this share; 0: not at all, it is counted
} Prediction;

// The n-th prediction (from 0) of the lab "03"; NULL past the last. It is called by the letter 'a' + n.
const Prediction *prediction_find(const char *lab, int n);

// The numbers of sheet `sheet` (above 0) for the n-th prediction of a lab: the same on every machine.
void prediction_draw(const Prediction *prediction, int n, long sheet, double given[PREDICTION_MAX_GIVEN]);

// Writes the question with these numbers; with NULL their names stand there in brackets.
void prediction_question(const Prediction *prediction, const double *given, char *text, size_t size);

// The closed form of a prediction of the lab for these numbers, for whoever measures it in a picture.
double prediction_answer(const char *lab, int n, const double given[PREDICTION_MAX_GIVEN]);

// Degrees in radians.
double prediction_radians(double degrees);
