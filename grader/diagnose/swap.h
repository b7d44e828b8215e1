// Finds the part of a submission with the fault: with our function in its place the checks pass that failed.
#pragma once

#include "diagnose/open_tasks.h"
#include "diagnose/result.h"

// Tries parts one after the other, the likely ones first; keeps the one that makes most of the checks in
// `failed` pass, and goes on, until all pass, nothing helps or the time for it is over. What is found is in
// fault->parts. False with a message when a file of ours cannot be read.
bool swap_find(Fault *fault, const LabResult *result, Exam *exam, const WorkerClient *student,
               const OpenTasks *tasks, const bool failed[]);
