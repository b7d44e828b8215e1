// A process beside the watch that grades one lab at a time and keeps what ours draw for it, so that the
// screen never waits and a lab that was saved again is graded at once.
#pragma once

#include "diagnose/result.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct VerdictCheck {
    double points;
    bool passed, undone;                     // undone: the task is not done yet, rather than done wrong
    char task[16], mistake[256], hint[1500]; // where to look, what is wrong and what helps; "" when passed
    char seen[256];                          // what is wrong with the picture
} VerdictCheck;

// The result of a lab without its pictures.
typedef struct LabVerdict {
    int lab; // as it was asked for
    LabStatus status;
    bool more;        // the causes are to come, in one more verdict
    bool done, fault; // fault: we could not grade, and message says why
    double score, max_score, seconds;
    char message[RESULT_TEXT], warnings[RESULT_TEXT];
    char summary[700]; // where to look first; "" when nothing is known to be wrong
    int check_count;
    VerdictCheck checks[RUBRIC_MAX_CHECKS];
    Predictions predictions;
} LabVerdict;

typedef struct GradingOptions {
    const char *folder;     // shaped like labs/
    const char *lab_folder; // or that of the one lab; NULL: none
    const Rubric *rubrics;
    uint64_t seed; // of all gradings
    ContextKind context;
    double seconds; // that a lab may run
} GradingOptions;

typedef struct GradingProcess {
    GradingOptions options;
    int pid, requests, verdicts; // our ends; no process while pid is 0
    bool busy;                   // a verdict is to come
    size_t taken;                // bytes of it
    char folder[FILES_PATH];     // for its temporary files, so that none stay when it is stopped
    LabVerdict verdict;
} GradingProcess;

// Asks for the grading of rubrics[lab]; starts the process when there is none. Only when not busy. False with
// a message.
bool grading_process_ask(GradingProcess *grading, int lab);

// Takes what has come from grading->verdicts. True when grading->verdict is whole; while it says `more`, the
// process stays busy. A process that is lost gives a verdict with a fault.
bool grading_process_take(GradingProcess *grading);

void grading_process_stop(GradingProcess *grading); // accepts a zeroed grading
