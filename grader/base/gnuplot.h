// Pictures by gnuplot.
#pragma once

#include <stdbool.h>

// Runs the script, a file in `folder`, there; gnuplot is looked for in PATH. False with what it said.
bool gnuplot_run(const char *folder, const char *script);
