// The whole study as one HTML page, without network: points that show their frame, its error and its setting.
#pragma once

#include "study/measure.h"

#include <stdio.h>

// Begins the page: grader/study/chart_page.html up to the place of its data. False with a message.
bool chart_page_begin(FILE *file);

// Adds a scene with all its pictures.
bool chart_page_add(FILE *file, const StudyPlan *plan, const SceneFindings *findings, bool is_first);

// The rest of chart_page.html.
bool chart_page_end(FILE *file);
