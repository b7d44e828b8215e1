// What a lab is graded by: solutions/NN-name/rubric.json, mistakes.json, alternatives.json and hints.json,
// read once (rubric_file.h).
//
// Interface: rubric_load (rubric_file.h) fills a Rubric, rubric_destroy frees it; between them it is read
// only. rubric_task, rubric_hint, rubric_mistake and rubric_alternative find parts of it.
#pragma once

#include "base/json_fields.h"
#include "base/limits.h"
#include "compile/task_blocks.h"
#include "lab.h"

#include <stdbool.h>

// What a knob is set to. Choices are walked through from variant to variant, from a place that the seed draws
// for the whole check: the lists of one check walk together, so the i-th choices of all belong together.
typedef struct KnobChoice {
    const char *name;
    float value; // the first choice, or the range's lower end: for who wants one setting only
    float choices[RUBRIC_MAX_CHOICES];
    int choice_count; // 0: see low and high
    float low, high;  // drawn for each variant
    bool whole;       // of the range: integers only, both ends included
} KnobChoice;

// One thing that is looked at, worth `points`.
typedef struct Check {
    const char *name;
    const char *task;  // "3.4"; "3" for a check about the whole lab
    const char *view;  // "picture", "visibility" or a stage of the lab
    const char *scene; // a name in common/scene/scenes.c, the first of `scenes`
    int points, variants;
    bool optional; // who leaves it untouched passes without it
    KnobChoice knobs[LAB_MAX_KNOBS];
    int knob_count;
    const char *scenes[RUBRIC_MAX_CHOICES]; // walked through as the knobs' choices are
    int scene_count;                        // at least 1 in a rubric that was read
    bool large;                             // its frames are larger than 640 x 480, see exam/exam_draw.h
} Check;

// The solution changed in a few places: a mistake (with its task and a hint) or another correct way.
typedef struct Change {
    const char *name, *task, *hint; // an alternative has no task and no hint
    Edit edits[CHANGE_MAX_EDITS];
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
    int prediction_points[RUBRIC_MAX_PREDICTIONS]; // of a, b, ...; see predict/prediction.h
    int prediction_count;
    Change *mistakes, *alternatives;
    int mistake_count, alternative_count;
    const Change *also[RUBRIC_MAX_ALSO]; // alternatives that draw other pictures, as right as the solution's
    int also_count;
    bool remarks; // who passes is told what could be better, without points
    Hint *hints;
    int hint_count;
    json_t *json; // where the strings live
} Rubric;

void rubric_destroy(Rubric *rubric); // accepts a zeroed rubric

// Where a check, or a mistake or alternative of this rubric stands in its file, for messages.
JsonPlace rubric_check_place(const Rubric *rubric, const Check *check);
JsonPlace rubric_change_place(const Rubric *rubric, const Change *change);

// Sum of the points of all checks and predictions.
int rubric_points(const Rubric *rubric);

// Sum of the points of all checks: the predictions count, but a lab passes without them.
int rubric_check_points(const Rubric *rubric);

// The task with the number n ("3.4" for 4); NULL when no check is about it.
const char *rubric_task(const Rubric *rubric, int n);

// The number of a task among all of the lab, from 0, in their order; -1 when there is no such task.
int rubric_task_index(const Rubric *rubric, const char *task);

// The n-th hint (from 0) of a task; NULL past the last.
const char *rubric_hint(const Rubric *rubric, const char *task, int n);

// Is the scene one of the check's?
bool rubric_uses_scene(const Check *check, const char *scene);

// The catalogued mistake, or alternative, of this name; NULL with a message when the lab has none.
const Change *rubric_mistake(const Rubric *rubric, const char *name);
const Change *rubric_alternative(const Rubric *rubric, const char *name);
