// What a failed check shows, in words.
#pragma once

#include "diagnose/suspects.h"

// Fills check->seen, when that says something beside the cause; c is the check's number in the exam. That its
// task has no effect is said of a suspect only: another task's fault can hide what it does.
void describe_check(CheckResult *check, int c, const Exam *exam, const Suspects *suspects);

// The task, when its checks among those in `failed` show the lab without it, and there is one; else NULL.
const char *describe_no_effect(const LabResult *result, const Exam *exam, const bool failed[],
                               const char *task);
