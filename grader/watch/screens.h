// What the watch shows.
#pragma once

#include "watch/lab_board.h"
#include "watch/text_sheet.h"

#include <stdbool.h>

// The lab on the desk: its checks, and of the first that failed the task, the cause and the hints. `busy`: it
// is being graded.
void screens_lab(Sheet *sheet, const Desk *desk, bool busy);

// All labs with how far each is; `marked` gets an arrow (-1: none).
void screens_list(Sheet *sheet, const Desk *desk, int marked);

// The keys, and what happens just now.
void screens_footer(char *text, size_t size, const Desk *desk, bool listing, bool busy);
