// What a student has done so far, kept in ROOT/.progress.json, which git ignores; SHADOW_LAB_PROGRESS names
// another file.
#pragma once

#include "grade/mistakes_met.h"

#include <stdbool.h>

typedef struct LabProgress {
    char id[3];
    double score, max_score; // of the last grading
    double best;             // of all
    bool done;               // every check that is not optional passed in the last grading
    char done_on[11];        // the day on which it was so first, "2026-11-25"; "" when it never was
} LabProgress;

typedef struct Progress {
    LabProgress labs[COURSE_MAX_LABS];
    int count;
    char note[1000]; // what the user should know: a damaged file was set aside; "" when all is well
} Progress;

// Reads the file; without one nothing is done yet. A damaged file is kept under another name and noted. False
// with a message when there is a file that cannot be read.
bool progress_load(Progress *progress);

// Puts one lab's grading into the file, which is replaced as a whole or left as it was, and reads all others
// from it again, so that several programs can do this at once. Beside the points the file keeps the names of
// all mistakes that were met (`met` may be NULL: none), and the seconds of work: the time since the grading
// before, when that was no longer ago than half an hour. False with a message.
bool progress_record(Progress *progress, const char *id, double score, double max_score, bool done,
                     const MistakesMet *met);

// The lab's entry; NULL when it was never graded.
const LabProgress *progress_find(const Progress *progress, const char *id);
