// The reader of what varies in a check: its scenes and its knobs.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

// "scene": a name, or a list of names. False with a message, as for the knobs.
bool rubric_choices_scenes(Check *check, const JsonPlace *place, const json_t *scenes);

// "knobs": of each a number, a list of numbers, or {"from": , "to": }; may be missing (NULL). Whether they
// are in the knobs' ranges: rubric_fit.h.
bool rubric_choices_knobs(Check *check, const JsonPlace *place, json_t *knobs);
