// The findings as a table, one line a setting, and two such tables compared.
#pragma once

#include "study/finding.h"

#include <stdio.h>

// The line of column names.
void findings_csv_head(FILE *file);
void findings_csv_write(FILE *file, const SceneFindings *findings);

// The same of the second table, a line for each setting in each view.
void findings_csv_views_head(FILE *file);
void findings_csv_views_write(FILE *file, const SceneFindings *findings);

// The same of the third table, a line for each frame that takes no method (baselines.h), beside the scene's
// limits; the edge's is 0 where there are no edges.
void findings_csv_lines_head(FILE *file);
void findings_csv_lines_write(FILE *file, const SceneFindings *findings);

// Prints which settings are on the front in one table only and whether the noise explains it: whether each
// one that keeps it off the front in one table and not in the other has overlapping error bars with it in at
// least one of them. `unexplained` gets the number of settings for which it does not. False with a message
// when a file cannot be read.
bool findings_csv_compare(const char *a, const char *b, FILE *out, int *unexplained);
