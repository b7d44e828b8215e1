// The words of a diagnosis: what to tell of a fault that was found, of a task that is suspected, of one that
// is not done.
#pragma once

#include "diagnose/catalogue.h"

// "in `at_infinity` (volume.geom)", with several parts "in ... and in ...".
void wording_place(char *text, size_t size, const Fault *fault);

// The cause of failed checks when no mistake of the catalogue may be named, and what helps.
void wording_cause(char *cause, size_t cause_size, char *hint, size_t hint_size, const LabResult *result,
                   const Suspects *suspects, const Rubric *rubric);

// Of a task that is open: "is not done", or where that is unsure, that it may have no effect yet.
const char *wording_open(bool unsure);

// Fills result->summary where nothing but open tasks was found: the first is `task`, of which wording_open
// says `open`.
void wording_next(LabResult *result, const char *task, const char *open);

// Fills result->summary and advice: where to look first and why. `mistake` is its name or NULL.
void wording_summary(LabResult *result, const char *mistake, const Suspects *suspects, const Rubric *rubric);

// The names of the mistakes, "A" or "A, or B".
void wording_names(char *text, size_t size, const Named *named, const Rubric *rubric);
