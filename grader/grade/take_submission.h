// From what was handed in to a lab that can be drawn.
#pragma once

#include "diagnose/result.h"
#include "exam/worker_client.h"

// Takes the lab's files from the folder `submission` into student->folder and compiles them there. What is
// wrong with them, and what is passed over, is told in the result. False with a message when the machine or
// we are to blame.
bool take_submission(LabResult *result, WorkerClient *student, const Rubric *rubric, const char *submission);
