// What the frames of a recorded exam tell beside their pixels, as JSON.
#pragma once

#include "exam/exam.h"

#include <jansson.h>

// Of variant n of check c, a new reference: the reference's facts, and then pairs of a number and facts where
// those of a known late picture are others. Mistakes are numbered from 0, tasks from EXAM_MAX_MISTAKES,
// parts (exam_reset.h) after them.
json_t *exam_facts_pack(const Exam *exam, int c, int n);

// The way back, into the variant and the late pictures; what the list lacks is 0.
void exam_facts_unpack(Exam *exam, int c, int n, json_t *list);
