// Grades one submission of one lab.
#pragma once

#include "exam/exam.h"
#include "exam/lab_exam.h"
#include "diagnose/result.h"

#include <stdbool.h>

// Draws the exam's frames with the student's worker and scores them; the frames stay in the result, which
// grade_begin has prepared. Timed: their times are compared with those of the solution.
void grade_frames(LabResult *result, Exam *exam, WorkerClient *student, bool timed);

// Draws and scores check c alone, and says whether it passes; the result, which grade_begin has prepared,
// gets neither a sum nor a status.
bool grade_check(LabResult *result, Exam *exam, WorkerClient *student, int c);

// Scores the frames that the result already holds, as grade_frames does once they are drawn.
void grade_pictures(LabResult *result, Exam *exam);

// The whole way of one lab: takes the files from the folder `submission`, compiles, draws, scores, names the
// mistakes, keeps pictures of what failed when the options ask for them. Everything that a submission can do
// wrong ends in the result; false with a message is a fault of ours (could not grade).
bool grade_lab(LabResult *result, LabExam *examiner, const char *submission, const GradeOptions *options);
