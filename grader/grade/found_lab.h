// What lies in a hand-in where a lab should be, in words: for its report, and for who only looks.
#pragma once

#include "compile/rubric.h"
#include "intake/submission.h"

// Tells of each file in the lab's folder that is taken for one of the lab's under another name, and of at
// most eight that are none of the lab's. False with a message when the folder cannot be read; errno says why.
bool found_lab_files(const Rubric *rubric, const char *folder, void (*say)(const char *text, void *context),
                     void *context);

// Why there is nothing of the lab that could be graded.
void found_lab_missing(char *text, size_t size, const Submission *submission, const Rubric *rubric);
