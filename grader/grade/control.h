// Experiments that tell whose fault a failure is: our own lab goes the way of a submission.
#pragma once

#include "exam/lab_exam.h"
#include "exam/worker_client.h"

// Is our solution compiled in the jail? False with a message: then the machine or we are to blame for what is
// not. Only where there are solutions.
bool control_compiles(const Rubric *rubric, const Jail *jail);

// Does the solution, drawn as `student` is, come out as the exam's reference? Asked once for each lab and
// then remembered in the examiner. False with a message. Needs exam->painters.
bool control_draws(LabExam *examiner, Exam *exam, const WorkerClient *student);
