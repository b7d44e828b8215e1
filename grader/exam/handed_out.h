// The files of a lab as students get them, with solutions at hand and without.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

// Is this copy of the project without solutions?
bool handed_out_alone(void);

// Is this the name of a file that students get with the lab?
bool handed_out_has(const Rubric *rubric, const char *name);

// The file number i as students get it, with every task to do; freed by the caller. NULL with a message.
char *handed_out_text(const Rubric *rubric, int i);
