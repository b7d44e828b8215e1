// What is shown when a lab is done: that it is, its idea, the answers to the handout's questions, what
// else to try.
#pragma once

#include "watch/lab_board.h"
#include "watch/sheet.h"

// A line that says that the current lab is done, and how to go on.
void after_lab_show_done(Sheet *sheet, const LabBoard *board);

// The lab's afterword, and where else to look. Only for who has done the lab: it holds the answers.
void after_lab_show(Sheet *sheet, const LabBoard *board, int lab);

// Prints that of the current lab, or that the lab is not done. True when it is done.
bool after_lab_print(const LabBoard *board, bool color);
