// Writes predictions.txt: the questions of a lab with the numbers of one sheet, and a ? for each answer.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

// Sheets that are drawn, from the least number on.
enum { PREDICTION_FIRST_SHEET = 1000, PREDICTION_SHEETS = 999000 };

// The file's text for a lab with predictions: with sheet 0 as it is handed out, where the questions have
// names in place of numbers. Freed by the caller.
char *prediction_sheet_text(const Rubric *rubric, long sheet);

// Writes the file into the lab's folder with a sheet that nobody can foresee, unless one stands there
// already, or numbers do. `drawn` says whether it was written. False with a message when it cannot be.
bool prediction_sheet_draw(const Rubric *rubric, const char *folder, bool *drawn);
