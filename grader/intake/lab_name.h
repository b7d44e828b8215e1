// Of which lab is a folder that a student has named?
#pragma once

#include <stdbool.h>

// Finds the number of a lab of ours in the name: "03-shadow-map", "3", "03_anything", "Lab 3", "lab03-ann",
// "Exercise_3", or our name without the number ("Shadow map"). False when there is none.
bool lab_name_find(char id[3], const char *name);

// The same from the text of a lab.c, whose .title is that of our lab.
bool lab_name_of_text(char id[3], const char *text);
