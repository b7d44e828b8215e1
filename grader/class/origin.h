// What the grades of a run are made by: the rubrics and the grader, as hashes. A record keeps them, so that a
// grade of another rubric is known for one.
#pragma once

#include "class/hand_in_facts.h"
#include "class/run_settings.h"

#include <jansson.h>

enum { ORIGIN_TEXT = 120 };
#define ORIGIN_GRADER "another grader"

typedef struct Origin {
    uint64_t grader;                   // the programs, and what labs and references are compiled with
    uint64_t rubrics[COURSE_MAX_LABS]; // of the plan's labs: all that lies in their folders but the handout
} Origin;

// Hashes the files as they are now. False with a message when a lab is not there.
bool origin_read(Origin *origin, const RunSettings *plan);

// What a record keeps: {"submission", "grader", "rubrics": {"03": ...}}, see class/record.schema.json.
json_t *origin_json(const Origin *origin, const RunSettings *plan, uint64_t submission);

// What is another in the record than it is now, in words: "another rubric of lab 03"; "" when nothing is.
// `submission` NULL: what was handed in is not looked at.
void origin_differs(char why[ORIGIN_TEXT], const json_t *record, const Origin *origin,
                    const RunSettings *plan, const uint64_t *submission);
