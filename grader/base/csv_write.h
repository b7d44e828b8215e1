// Cells of a table that no spreadsheet takes for a formula.
#pragma once

#include <stdbool.h>
#include <stdio.h>

// Does a spreadsheet take a cell that begins so for a formula? ' itself counts, too: it is what tells it not
// to, and a cell that begins with it gets a second one.
bool csv_is_formula(const char *text);

// Writes the first line of the text as a cell in quotes, with a ' before what would be a formula.
void csv_write_cell(FILE *out, const char *text);
