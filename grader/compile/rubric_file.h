// The reader of a lab's rubric.json, mistakes.json, alternatives.json and hints.json: what each may hold.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

enum { RUBRIC_JSON, MISTAKES_JSON, ALTERNATIVES_JSON, HINTS_JSON, RUBRIC_FILES };

// Reads the files in `folder`, named "NN-name". False with a message that names file and entry of what is
// wrong: what the files alone show. What only the lab itself shows: rubric_fit.h.
bool rubric_load(Rubric *rubric, const char *folder);

// rubric_load, which reads a file only where its text is NULL.
bool rubric_read(Rubric *rubric, const char *folder, const char *const texts[RUBRIC_FILES]);
