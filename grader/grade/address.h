// A crash is drawn once more with AddressSanitizer, which finds where the memory was damaged rather than
// where that was noticed.
#pragma once

#include "diagnose/result.h"
#include "exam/worker_client.h"

#include <stdbool.h>

// Compiles the student's lab anew and draws the frame of student->crash again. What is found is added to the
// result's message, and to the checks that crashed as their hint. Says nothing when there is no crash, no
// library of the sanitizer or nothing found.
void address_explain(LabResult *result, const WorkerClient *student, const Rubric *rubric);
