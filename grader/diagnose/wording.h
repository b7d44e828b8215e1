// The words of a diagnosis: what to tell of a fault that was found, of a task that is suspected, of one that
// is not done.
#pragma once

#include "diagnose/catalogue.h"

// "in `at_infinity` (volume.geom)", with several parts "in ... and in ...".
void wording_place(char *text, size_t size, const Fault *fault);

// The cause of failed checks when no mistake of the catalogue may be named, and what helps.
void wording_cause(char *cause, size_t cause_size, char *hint, size_t hint_size, const LabResult *result,
                   const Suspects *suspects, const Rubric *rubric);

// Fills result->summary and advice: where to look first and why. `mistake` is its name or NULL; `open` the
// first task that is not done or NULL.
void wording_summary(LabResult *result, const char *mistake, const Suspects *suspects, const char *open,
                     const Rubric *rubric);

// The names of the mistakes, "A" or "A, or B".
void wording_names(char *text, size_t size, const Named *named, const Rubric *rubric);
