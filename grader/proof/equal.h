// The changes of a solution that are equal in effect, and why: solutions/NN-name/equal.json, a list of
//
//     {"why": "the picture is opaque", "changes": [
//         {"file": "shade.frag", "line": "o_color = vec4(color, 1.0)", "from": "1.0", "to": ["0.0", "2.0"]}]}
//
// "line" is a part of the line in which the change begins, with lines that follow where it must be told from
// an equal one; without "to" any change of "from" is meant. "nth": 2 means the second place in the line where
// "from" changes, "task": "3.6" only the answer to that task; else all are meant.
#pragma once

#include "compile/rubric.h"
#include "proof/mutant.h"

#include <stdbool.h>

typedef struct EqualChange {
    const char *file, *line, *from, *why;
    const char *task;  // NULL: any
    struct json_t *to; // a list of texts; NULL: any
    int nth;           // 0: any
    int matched;       // how many mutants it names
} EqualChange;

typedef struct EqualList {
    EqualChange *changes;
    int count;
    struct json_t *json; // where the texts live
} EqualList;

// Reads the rubric's equal.json; a lab without one has no such changes. The message names what is wrong.
bool equal_load(EqualList *list, const Rubric *rubric);
void equal_destroy(EqualList *list); // accepts a zeroed list

// The entry that names this mutant of the text of `file`, and counts it there; NULL when there is none.
const EqualChange *equal_find(EqualList *list, const char *file, const char *text, const Mutant *mutant);
