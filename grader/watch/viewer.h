// Starts the window (build/view) beside the watch and tells what became of it.
#pragma once

#include "watch/lab_board.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct Viewer {
    int pid; // 0: none runs
    int log; // what it prints
} Viewer;

// Opens the window for the lab of the board that is worked on, on the first check that failed. Says in the
// board's message whether it opens.
void viewer_open(Viewer *viewer, LabBoard *board);

// Looks whether the window has ended. True when it failed, with its own words in `message`.
bool viewer_failed(Viewer *viewer, char *message, size_t size);
