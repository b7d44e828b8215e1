// What becomes of the records of a class: tables, pages, exports.
#pragma once

#include "book/book_open.h"
#include "class/class_settings.h"

typedef struct GradebookSettings {
    BookFiles files;
} GradebookSettings;

// A ClassTables of class/class.h; `context` is a GradebookSettings. What people should know of the list of
// students and of grades that are not by today's rubric goes to standard error.
bool gradebook_write(const Table *table, const ClassSettings *settings, void *context);
