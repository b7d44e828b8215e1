// Which catalogued mistakes a grading has found, by their names.
#pragma once

#include "compile/rubric.h"

typedef struct MistakesMet {
    const char *names[RUBRIC_MAX_CHECKS]; // the rubric's, each once
    int count;
} MistakesMet;

// Adds the mistake that the cause of a failed check names first; what is no catalogued mistake is left out.
void mistakes_met_add(MistakesMet *met, const Rubric *rubric, const char *cause);
