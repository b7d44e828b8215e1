// All small changes of one lab's solution, and what they are tried with.
#pragma once

#include "exam/lab_exam.h"
#include "proof/mutant.h"
#include "proof/trial.h"

enum { CHANGE_TEXT = 1200 };

typedef struct LabChanges {
    LabExam examiner;
    Court court; // without an exam, see lab_exam_exam
    Mutants mutants;
} LabChanges;

// Reads the lab's sources, builds its solution and lists the changes. False with a message; the caller closes
// it then, too.
bool lab_changes_open(LabChanges *changes, const char *id);
void lab_changes_close(LabChanges *changes); // accepts zeroed ones

// Writes change i for people: "03 lab.c:36 (3.6): 1 (place 2) -> 0".
void lab_changes_describe(char text[CHANGE_TEXT], const LabChanges *changes, int i);
