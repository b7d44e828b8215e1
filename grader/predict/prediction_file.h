// Reads what a student has typed: predictions.txt, a line for each number, a letter before it. Whatever else
// stands there ends in one message, and costs nothing but the number that it is about.
#pragma once

#include "base/limits.h"

#define PREDICTION_FILE "predictions.txt"

enum { PREDICTION_MAX_FILE = 1 << 16, PREDICTION_NUMBER = 24, PREDICTION_MESSAGE = 320 };

typedef struct PredictionEntry {
    double value;                  // when `why` is ""
    char typed[PREDICTION_NUMBER]; // what stands there, printable; "" while nothing, or a ?, does
    char why[PREDICTION_MESSAGE];  // what is wrong with the line; "" when a number stands there
} PredictionEntry;

typedef struct PredictionFile {
    long sheet;  // 0: none yet
    int entries; // that a lab has, from letter a on
    PredictionEntry entry[RUBRIC_MAX_PREDICTIONS];
    char message[PREDICTION_MESSAGE]; // what is wrong as a whole, "" when nothing is
} PredictionFile;

// Takes the text apart, which may hold any characters, for a lab of so many predictions. `file` is filled in
// whatever it holds.
void prediction_file_read(PredictionFile *file, const char *text, int entries);
