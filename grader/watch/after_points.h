// What is shown of a student's methods when a lab is done: how much they err and how long they take, beside
// ours.
#pragma once

#include "compile/rubric.h"
#include "watch/sheet.h"

// From what make study has measured, some scenes in words: BUILD/study-NN.csv. Where it has not measured yet,
// and could, says so; where nothing is recorded of the lab, shows nothing. `folder` holds the lab's files:
// when one of them is newer than the numbers, that is said.
void after_points_show(Sheet *sheet, const Rubric *rubric, const char *folder);
