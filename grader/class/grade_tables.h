// Makes OUT/grades.csv and OUT/index.html from the records of the class.
#pragma once

#include "class/run_settings.h"
#include "class/roster.h"

#include <stdbool.h>

// `not_graded` gets the number of submissions without a grade. False with a message.
bool grade_tables_write(const char *output, const Roster *roster, const RunSettings *plan, int *not_graded);
