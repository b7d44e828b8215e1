// One changed solution before the rubric: is the change noticed?
#pragma once

#include "compile/rubric.h"
#include "exam/exam.h"
#include "proof/absence.h"
#include "proof/mutant.h"

#include <stdbool.h>

enum { TRIAL_TEXT = 300 };

typedef enum Verdict {
    VERDICT_OPEN,     // not tried yet
    VERDICT_NOT_MADE, // it does not compile
    VERDICT_KILLED,   // a check fails, or nothing is drawn, or it runs too long
    VERDICT_SURVIVED  // every check passes
} Verdict;

// What the changes of one lab are tried with.
typedef struct Court {
    const Rubric *rubric;
    char *texts[RUBRIC_MAX_FILES]; // the annotated sources, in the order of rubric->files
    char solution[FILES_PATH];     // the folder of ours: who changes a shader takes lab.so from there
    Exam *exam;
} Court;

// Reads the sources and builds the solution; false with a message. The rubric must outlive the court.
bool court_open(Court *court, const Rubric *rubric);
void court_close(Court *court); // accepts a zeroed court; the exam is not its own

// Builds and draws the lab with this change, by a worker of its own, checks of the change's task first, and
// stops at the first check that fails. `told` gets what a student would read though all checks pass, "" for
// nothing. False with a message: a fault of ours.
bool trial_run(const Court *court, const Mutant *mutant, Verdict *verdict, char told[TRIAL_TEXT]);

// What an object's absence does to a change that is killed: nothing, or it survives without the object.
typedef enum Loss { LOSS_NONE = '.', LOSS_KILL = 'k' } Loss;

// Grades the change as trial_run does, and each check that fails once more without each of these things,
// until it is certain that none of them matters. (Of a change that crashes or takes too long, none does.)
// losses[i] gets a Loss, and losses[count] the end of a text. False with a message: a fault of ours.
bool trial_without(const Court *court, const Mutant *mutant, const Absence *absences, int count,
                   char *losses);
