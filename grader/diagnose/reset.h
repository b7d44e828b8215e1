// Finds the parts of a submission that can have the fault where no solution is at hand: with such a part as
// it was handed out, the rest draws what ours draws with the same part as it was handed out.
#pragma once

#include "diagnose/open_tasks.h"
#include "diagnose/suspects.h"

// By the numbers of exam_parts.
typedef struct ResetFound {
    bool any;                     // of `parts`
    bool parts[EXAM_MAX_PARTS];   // those with which the rest draws right
    bool both;                    // two faults: each of two parts explains a part of the failed checks
    bool unknown[EXAM_MAX_PARTS]; // those that could not be tried
    Known known;                  // of the tasks in these parts
    int failed;                   // checks that were looked at
    bool stopped;                 // the time was over before all was tried
} ResetFound;

// Tries each part that the student has changed, or not done. A part that leaves a wrong picture in a failed
// check is acquitted. False with a message when a file of ours cannot be read.
bool reset_find(ResetFound *found, const LabResult *result, Exam *exam, const WorkerClient *student,
                const OpenTasks *tasks, const bool failed[]);

// Writes down the found parts in which a suspect is done; nothing when these are more than FAULT_PARTS, or
// when a suspect may be done in a part that could not be tried.
void reset_note(Fault *fault, const ResetFound *found, const Suspects *suspects, const Parts *parts);

// Describes the part with this number.
void reset_part(FaultPart *part, const Parts *parts, int p);
