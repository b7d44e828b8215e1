// Two outputs of class runs side by side: who has other points, by how much, and by which checks.
#pragma once

#include <stdbool.h>
#include <stdio.h>

// Prints what is different to `out`. With a folder `csv_folder` (NULL: none) also writes changes.csv there: a
// row for each total and each check that changed. False with a message when one of the folders holds no
// records.
bool compare_outputs(const char *old_folder, const char *new_folder, const char *csv_folder, FILE *out);
