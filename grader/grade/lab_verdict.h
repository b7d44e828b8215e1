// What a result says of a lab as a whole.
#pragma once

#include "compile/rubric.h"
#include "diagnose/result.h"

// An empty result with the checks and the predictions of the rubric.
void grade_begin(LabResult *result, const Rubric *rubric);

// Nothing of the submission could be drawn, for this reason.
void grade_refuse(LabResult *result, const char *reason);

// The lab failed so; what was said of it first stays.
void grade_fail(LabResult *result, LabStatus status, const char *message);

// What the lab printed, for who debugs in this way: a warning of its first lines.
void grade_quote(LabResult *result, const char *printed);

// One more warning for who handed it in, unless it is there already; "" is none.
void grade_warn(LabResult *result, const char *text);
