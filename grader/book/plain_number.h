// Students' numbers as spreadsheets leave them.
#pragma once

#include <stdbool.h>
#include <stddef.h>

// Writes the number of a cell as it is meant: without the ="..." around a text, the spaces between digits and
// the ".0" of a column of numbers. What is no number stays as it is. False: only "1.23E+11" is left of it,
// and nobody can tell the rest.
bool plain_number(char *number, size_t size, const char *cell);
