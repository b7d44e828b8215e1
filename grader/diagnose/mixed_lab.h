// The student's lab with some parts of ours in it, drawn in the jail. Of what it draws only this comes out:
// which checks pass. Pictures, messages and prints are thrown away.
#pragma once

#include "compile/functions.h"
#include "diagnose/result.h"

#include <stdbool.h>

// One file of the lab.
typedef struct MixedFile {
    const char *name; // the rubric's
    char *text, *ours_text;
    Functions theirs, ours; // of them
    Choice choice;          // what is ours
    bool all_ours;          // the whole file
} MixedFile;

typedef struct MixedLab {
    const LabResult *result;
    Exam *exam;
    const WorkerClient *student; // whose folder, jail and context are taken
    MixedFile files[RUBRIC_MAX_FILES];
    bool failed[RUBRIC_MAX_CHECKS]; // the checks to draw
    int failed_count;
} MixedLab;

// Reads the student's files and our sources with these tasks solved; NULL: the files as they were handed out.
// False with a message.
bool mixed_lab_open(MixedLab *lab, const LabResult *result, Exam *exam, const WorkerClient *student,
                    const Solved *solved);
void mixed_lab_close(MixedLab *lab); // accepts a zeroed one

// How many of the failed checks pass as the files are chosen now; -1 when that does not compile or draw.
int mixed_lab_try(const MixedLab *lab);

// Takes what the lab draws in the worst variant of check c; `picture` is valid until it returns.
typedef void MixedJudge(void *context, int c, const Image *picture, const FrameFacts *facts);

// Draws the failed checks as the files are chosen now. False when that does not compile, or not all of them
// were drawn.
bool mixed_lab_draw(const MixedLab *lab, MixedJudge *judge, void *context);
