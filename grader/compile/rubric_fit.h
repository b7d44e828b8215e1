// Does a rubric fit its lab? What only the lab itself shows, when its solution is there.
#pragma once

#include "compile/rubric.h"
#include "protocol/protocol.h"

#include <stdbool.h>

// Has the lab, described by its solution's worker, the views and knobs that the checks name, and are the
// values in the knobs' ranges? False with a message.
bool rubric_fit_lab(const Rubric *rubric, const Description *lab);

// Has the lab a block "#ifdef SOLUTION // 3.1" for each task of a check, and can each mistake and alternative
// be made of its sources? False with a message.
bool rubric_fit_sources(const Rubric *rubric);
