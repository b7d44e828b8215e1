// What comes out of grading. Plain data; strings from the rubric live as long as it does.
#pragma once

#include "compile/hunks.h"
#include "exam/exam.h"
#include "predict/predictions.h"
#include "score/difference.h"

#include <stdbool.h>
#include <stdint.h>

enum { RESULT_TEXT = 8000 };

// Pictures of the worst variant of a failed check; the last is an enlarged crop of the others side by side.
enum { EVIDENCE_YOURS, EVIDENCE_REFERENCE, EVIDENCE_DIFFERENCE, EVIDENCE_CROP, EVIDENCE_PARTS };

typedef struct CheckResult {
    const Check *check;
    double share;   // of the points; the worst variant counts
    double error;   // inside + outside of that variant (see score.h)
    int worst;      // that variant
    bool passed;    // all but a trace of the points
    bool otherwise; // ... by the pictures of an alternative that is "also right"
    bool begun;     // of a submission: the TODO of its task is gone from the files
    FrameFacts facts[EXAM_MAX_VARIANTS];
    bool wrong_size,
        refused; // of the worst variant: its stage has not the reference's size; GL refused a call
    bool has_cause;
    bool undone;            // the cause: a task is not done yet, rather than done wrong
    const char *cause_task; // where to look; NULL when it is the check's own task
    char mistake[256], hint[1500];
    char seen[256]; // what is wrong with the picture, in words; "" when that says no more than the cause
    char kind[256]; // the mistake without the numbers of these pictures: the same for all who made it
    Image yours[EXAM_MAX_VARIANTS]; // owned; empty where no frame was drawn
    Image evidence[EVIDENCE_PARTS]; // owned; empty when the check passed or nobody asked for it
    Difference difference;          // the evidence's
} CheckResult;

enum { FAULT_PARTS = 3, FAULT_TASKS = 4 };

// A part of a submission that was exchanged.
typedef struct FaultPart {
    const char *file;  // the rubric's
    char function[64]; // the student's name of it; "": all that stands outside of functions, or with `whole`
                       // the whole file
    bool whole;
    char ours[64];     // our name of the function
    Hunks hunks;       // of a function: where the student's reads otherwise than ours
    bool given;        // what was handed out has changed there, too, or nothing can be told
    char helpers[128]; // the student's own functions that it calls, "a, b"
    const char
        *tasks[FAULT_TASKS]; // that are done there, the most likely first; all NULL in what was handed out
} FaultPart;

// With our parts in the place of these, `repaired` of the `failed` checks pass. Or, where ours are not at
// hand: with these parts as they were handed out, the lab draws in so many of them what ours does that has
// the same part as it was handed out.
typedef struct Fault {
    FaultPart parts[FAULT_PARTS];
    int count, failed, repaired;
    bool reset;   // the parts were as handed out
    bool either;  // one of the parts has the fault, and not each
    bool stopped; // the time was over before all was tried
} Fault;

typedef enum LabStatus { LAB_PASSED, LAB_FAILED, LAB_ERROR, LAB_TIMEOUT } LabStatus;

typedef struct LabResult {
    char id[3];
    char name[64]; // the title, a copy
    LabStatus status;
    bool missing; // not handed in: no points, and no part of any mean
    double score, max_score;
    double speed_ratio;        // CPU time to the solution's, median over the frames; 0 when nothing was drawn
    char message[RESULT_TEXT]; // what went wrong as a whole, "" when nothing did
    char warnings[RESULT_TEXT]; // gcc's, GL's and remarks about ignored files
    char summary[700],
        advice[1500]; // where to look first and why, in a line, and what helps; "" when all passed
    Fault fault;      // no parts when none was found
    bool first_only;  // what is wrong is right in the first frame: something is kept from it
    int check_count;
    CheckResult checks[RUBRIC_MAX_CHECKS];
    Predictions predictions;
} LabResult;

typedef struct Report {
    uint64_t seed;
    bool hidden; // the seed is no business of who handed it in
    const char *context;
    const char *jail; // the route: "bwrap", "landlock" or "none"
    char renderer[128];
    double seconds;
    int lab_count;
    LabResult *labs; // COURSE_MAX_LABS, owned
} Report;

// As in the JSON: "passed", ...
const char *result_status_name(LabStatus status);
double result_points(const CheckResult *check); // rounded to hundredths

// Are all pictures of the check still those of the solution without its task, or else of the skeleton?
typedef enum Touch { TOUCH_TASK_MISSING, TOUCH_AS_SKELETON, TOUCH_CHANGED } Touch;
Touch result_touch(const CheckResult *check, const Variant *variants);
// Is there nothing left to do: did every check pass that is not optional?
bool result_done(const LabResult *lab);

// Are there checks about the task with this index (see rubric_task_index), and did all pass?
bool result_task_passed(const LabResult *lab, const Rubric *rubric, int task);

// Did the lab draw at least one frame?
bool result_was_drawn(const LabResult *lab);
double result_score(const Report *report);
double result_max_score(const Report *report);
void result_destroy_lab(LabResult *lab); // accepts a zeroed result

// Copies `text` with every byte that is not printable ASCII or a line end written as \xNN.
void result_clean(char *clean, size_t size, const char *text);
