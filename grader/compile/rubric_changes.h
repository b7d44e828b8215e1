// The reader of mistakes.json, alternatives.json and hints.json, once the rubric's checks are known.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

// Each takes the file's content, which rubric->json keeps. False with a message.
bool rubric_changes_mistakes(Rubric *rubric, const JsonPlace *file, json_t *root);
bool rubric_changes_alternatives(Rubric *rubric, const JsonPlace *file, json_t *root);
bool rubric_changes_hints(Rubric *rubric, const JsonPlace *file, json_t *root);
