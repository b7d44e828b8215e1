// The gradebook as a database, for queries.
#pragma once

#include "book/book.h"

// Writes grades.sqlite into the folder, by the program sqlite3: tables student, lab, grade, `check` and
// mistake (book/README.md). False with a message.
bool export_sqlite(const Book *book, const char *folder);
