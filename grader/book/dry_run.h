// What a class run would find and grade, without grading.
#pragma once

#include "book/book_open.h"
#include "class/class_settings.h"

typedef struct DryRun {
    BookFiles files;
    int strange; // gets the number of hand-ins that need a look: nothing in them, or not all of it, can be
                 // graded
} DryRun;

// A ClassTables of class/class.h; `context` is a DryRun. Opens each hand-in (archives in the jail) and prints
// what it holds: whose it is, when it came, the folders and files of the labs, what is taken under another
// name and what is passed over. What needs a look stands behind a "!". Writes nothing but temporary files.
bool dry_run_print(const Table *table, const ClassSettings *settings, void *context);
