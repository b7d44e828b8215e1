// A private folder for what a run needs only while it lasts, named by the link OUT/work, so that the next run
// finds and removes what a killed one left.
#pragma once

#include <stdbool.h>

// Removes what is left of earlier runs in OUT, makes the folder and makes it the place of all temporary files
// (TMPDIR). Only for who is alone in OUT. False with a message.
bool run_folder_create(const char *output);

// Removes the folder; temporary files go again where they went before.
void run_folder_destroy(const char *output);
