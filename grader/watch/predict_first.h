// What is asked for before a lab runs for the first time: the student's predictions.
#pragma once

#include "watch/lab_board.h"
#include "watch/sheet.h"

#include <stdbool.h>

// Puts a sheet of the student's own into a lab's predictions where there is none yet. What cannot be written
// is told when it is graded.
void predict_first_draw(const LabBoard *board, int lab);

// The same for the current lab, and prints what became of it. False with a message on stderr.
bool predict_first_print(const LabBoard *board);

// Asks for the numbers that are still to be typed, and tells what is wrong with the others.
void predict_first_show(Sheet *sheet, const LabBoard *board);
