// Starts the window (build/view) beside the watch and tells what became of it.
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct Viewer {
    int pid; // 0: none runs
    int log; // what it prints
} Viewer;

// Opens the window for the lab "03", or says in `message` why not.
void viewer_open(Viewer *viewer, const char *id, char *message, size_t size);

// Looks whether the window has ended. True when it failed, with its own words in `message`.
bool viewer_failed(Viewer *viewer, char *message, size_t size);
