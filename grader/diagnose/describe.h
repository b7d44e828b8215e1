// What a failed check shows, in words.
#pragma once

#include "diagnose/open_tasks.h"

// Fills check->seen, when that says something beside the cause; c is the check's number in the exam.
void describe_check(CheckResult *check, int c, const Exam *exam, const OpenTasks *tasks);

// The task, when its checks among those in `failed` show the lab without it, and there is one; else NULL.
const char *describe_no_effect(const LabResult *result, const Exam *exam, const bool failed[],
                               const char *task);
