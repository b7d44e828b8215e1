// What a program says about its command line.
#pragma once

#include "base/option_table.h"

#include <stdio.h>

// The forms, a line each: "usage: build/grade [options] SUBMISSION".
void command_help_forms(const CommandLine *line, FILE *out);

// All of it: the forms, what the program does, and a line for each option, --help among them.
void command_help_print(const CommandLine *line, FILE *out);
