// Grades a whole class: one submission a folder or archive, some at a time, in a way that can be stopped at
// any moment and taken up again. See grader/README.md.
#pragma once

#include "class/grade_options.h"

// Does what the options of --class ask for; returns the exit status of the program.
int class_run(Options *options);
