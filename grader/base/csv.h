// Tables as people and programs export them: cells separated by commas, semicolons or tabs, in quotes or not,
// with any ends of lines, with a byte order mark and with empty lines.
#pragma once

#include "base/files.h"

#include <stdbool.h>

enum { CSV_MAX_BYTES = 16 << 20, CSV_MAX_COLUMNS = 500 };

typedef struct CsvLine {
    int line;     // of the file, from 1, where it begins
    char **cells; // one a head; "" where the row is shorter
} CsvLine;

typedef struct Csv {
    char path[FILES_PATH];
    char **heads;
    int column_count;
    CsvLine *rows; // without the heads and without rows of empty cells
    int count;
    char *text; // holds all cells
} Csv;

// Reads the file. Cells come without spaces around them, and without the ' that csv_write_cell puts before
// what a spreadsheet would take for a formula. False with a message that names file, line and remedy.
bool csv_read(Csv *csv, const char *path);
void csv_destroy(Csv *csv); // accepts a zeroed table

// The first column that has one of the names, tried in their order; of a head only letters and digits count,
// and not their case. `names` ends with NULL. -1 when there is none.
int csv_column(const Csv *csv, const char *const *names);

// Is no other column named like this one? False with a message. True for the column -1.
bool csv_named_once(const Csv *csv, int column);

// A cell; "" for the column -1.
const char *csv_cell(const Csv *csv, int row, int column);

// check_fail with "FILE:LINE: " of the row before the message; row -1 is the line of the heads.
bool csv_fail(const Csv *csv, int row, const char *format, ...) __attribute__((format(printf, 3, 4)));
