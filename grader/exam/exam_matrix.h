// Which checks fail when one thing is wrong: evidence for and against it.
#pragma once

#include "exam/exam.h"

#include <jansson.h>

// Check c with our lab in which only the task with this index (see rubric_task_index) is not done. Drawn when
// it is first asked for. EXAM_UNKNOWN with a message when ours cannot draw it.
ExamEntry exam_without_task(Exam *exam, int t, int c);

// Check c with our lab with mistake m.
ExamEntry exam_with_mistake(Exam *exam, int m, int c);

// All of exam_without_task as JSON: of each task a string with a letter for each check, F where it fails.
json_t *exam_matrix_pack(Exam *exam);

// The way back. False when the list does not fit the rubric.
bool exam_matrix_unpack(Exam *exam, json_t *list);
