// Our lab in which a part is as it was handed out: what a lab draws whose rest is right, whatever its own
// part draws.
#pragma once

#include "exam/exam.h"

#include <jansson.h>

// The lab's parts, made when first asked for; valid while the exam is. NULL with a message when the files as
// they were handed out cannot be read.
const Parts *exam_parts(Exam *exam);

// The picture of the solution with part p as it was handed out, in variant n of check c; its facts are in
// exam->resets. NULL with a message when ours cannot draw it.
const Image *exam_reset(Exam *exam, int p, int c, int n);

// With part p as it was handed out, can be seen in check c whether part q is, too? EXAM_HIDDEN: no. Asked in
// the check's first variant.
ExamHidden exam_hidden(Exam *exam, int p, int q, int c);

// All of exam_hidden as JSON: of each part a list with a text for each other part, a letter a check.
json_t *exam_hidden_pack(Exam *exam);

// The way back. False when the list does not fit the lab's parts.
bool exam_hidden_unpack(Exam *exam, json_t *list);
