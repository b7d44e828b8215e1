// OUT/grades.csv: a row a student.
#pragma once

#include "book/book.h"

// Writes it. A column of each lab has the points that count; where overrides or a rule for lateness are
// given, columns behind have what was measured; with a rule for lateness also when it was handed in, and by
// what that is known. False with a message.
bool grades_csv_write(const char *output, const Book *book);
