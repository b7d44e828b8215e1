// A report for people and for programs.
#pragma once

#include "result.h"

#include <stdbool.h>
#include <stdio.h>

// One line a check, a bar a lab; with the colours of a terminal when `color`.
void report_text(const Report *report, FILE *out, bool color);

// The JSON of grader/schema.json. False when it cannot be written.
bool report_json(const Report *report, FILE *out);

// Writes yours, reference and difference of each failed check's worst variant, and an enlarged crop of all
// three where most is wrong, as PNG to folder/NN/CHECK-*.png.
bool report_evidence(const LabResult *result, const Exam *exam, const char *folder);
