// What a lab is graded by: solutions/NN-name/rubric.json, mistakes.json, alternatives.json and hints.json,
// read once.
#pragma once

#include "compile/task_blocks.h"

#include <stdbool.h>

enum { RUBRIC_MAX_CHECKS = 16, RUBRIC_MAX_FILES = 8, RUBRIC_MAX_KNOBS = 4, RUBRIC_MAX_EDITS = 6 };

// One thing that is looked at, worth `points`.
typedef struct Check {
    const char *name;
    const char *task;  // "3.4"; "3" for a check about the whole lab
    const char *view;  // "picture", "visibility" or a stage of the lab
    const char *scene; // a name in common/scene/scenes.c
    int points, variants;
    bool optional; // who leaves it untouched passes without it
    struct {
        const char *name;
        float value;
    } knobs[RUBRIC_MAX_KNOBS];
    int knob_count;
} Check;

// The solution changed in a few places: a mistake (with its task and a hint) or another correct way.
typedef struct Change {
    const char *name, *task, *hint;
    Edit edits[RUBRIC_MAX_EDITS];
    int edit_count;
} Change;

typedef struct Hint {
    const char *task;
    const char **texts; // in the order of their frankness
    int count;
} Hint;

// All strings belong to the rubric and live until rubric_destroy.
typedef struct Rubric {
    char id[3];         // "03"
    const char *folder; // solutions/03-shadow-map
    const char *title;
    double pass_mark;                    // percent of the points
    const char *files[RUBRIC_MAX_FILES]; // what a student hands in; all else is ignored
    int file_count;
    Check checks[RUBRIC_MAX_CHECKS];
    int check_count;
    Change *mistakes, *alternatives;
    int mistake_count, alternative_count;
    Hint *hints;
    int hint_count;
    struct RubricJson *json; // where the strings live
} Rubric;

// Reads the files in `folder`. The message names file and entry of what is wrong.
bool rubric_load(Rubric *rubric, const char *folder);
void rubric_destroy(Rubric *rubric); // accepts a zeroed rubric

// Sum of the points of all checks.
int rubric_points(const Rubric *rubric);

// The task with the number n ("3.4" for 4); NULL when no check is about it.
const char *rubric_task(const Rubric *rubric, int n);

// The number of a task among all of the lab, from 0, in their order; -1 when there is no such task.
int rubric_task_index(const Rubric *rubric, const char *task);

// The n-th hint (from 0) of a task; NULL past the last.
const char *rubric_hint(const Rubric *rubric, const char *task, int n);

// The catalogued mistake, or alternative, of this name; NULL with a message when the lab has none.
const Change *rubric_mistake(const Rubric *rubric, const char *name);
const Change *rubric_alternative(const Rubric *rubric, const char *name);
