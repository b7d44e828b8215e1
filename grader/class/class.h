// Grades a whole class: one submission a folder or archive, some at a time, in a way that can be stopped at
// any moment and taken up again. See grader/class/README.md.
#pragma once

#include "class/class_settings.h"
#include "class/table.h"

// Makes tables and pages in settings->output of the records there. False with a message.
typedef bool (*ClassTables)(const Table *table, const ClassSettings *settings, void *context);

// Grades nothing and writes nothing; a dry run's `make_tables` says what there is. Else:
// Grades what has no grade yet, or one of something else than is there now, and lets `make_tables` make the
// tables, one process at a time. False when something is not graded; what and why is on standard error or in
// the table.
bool class_run(const ClassSettings *settings, ClassTables make_tables, void *context);
