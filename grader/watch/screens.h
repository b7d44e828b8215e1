// What the watch shows.
#pragma once

#include "watch/lab_board.h"
#include "watch/sheet.h"

#include <stdbool.h>

// The current lab: its checks, and of the first that failed the task, the cause and the hints. `busy`: it
// is being graded.
void screens_lab(Sheet *sheet, const LabBoard *board, bool busy);

// All labs with how far each is; `marked` gets an arrow (-1: none). Returns the line of the marked one.
int screens_list(Sheet *sheet, const LabBoard *board, int marked);

// The keys, and what happens just now.
void screens_footer(char *text, size_t size, const LabBoard *board, bool listing, bool busy);
