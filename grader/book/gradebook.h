// What becomes of the records of a class: tables, pages, exports.
#pragma once

#include "book/book_open.h"
#include "book/export.h"
#include "class/class_settings.h"

typedef struct GradebookSettings {
    BookFiles files;
    bool exports[EXPORT_KINDS];
    const char *anonymous; // the file of pseudonyms; NULL: no anonymous pages
    bool copies;           // compare the code of all hand-ins
    bool no_points;        // on pages that are given away
} GradebookSettings;

// Does it ask for pages or tables that are given away?
bool gradebook_gives_away(const GradebookSettings *wanted);

// Does it ask for anything?
bool gradebook_is_asked_for(const GradebookSettings *wanted);

// A ClassTables of class/class.h; `context` is a GradebookSettings. What people should know of the list of
// students and of grades that are not by today's rubric goes to standard error.
bool gradebook_write(const Table *table, const ClassSettings *settings, void *context);
