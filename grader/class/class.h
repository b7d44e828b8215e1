// Grades a whole class: one submission a folder or archive, some at a time, in a way that can be stopped at
// any moment and taken up again. See grader/class/README.md.
#pragma once

#include "class/class_settings.h"

// Grades, and writes what it finds to settings->output. False when something is not graded; what and why is
// on standard error or in the table.
bool class_run(const ClassSettings *settings);
