// What objects that no known mistake needs (scene_power.h) are worth to the mutation test, whose changes are
// finer: which small changes of the solution would be noticed no more without one?
#pragma once

#include "proof/lab_changes.h"

#include <stdbool.h>

typedef struct ObjectWorth {
    const char *scene;
    int thing;   // an object, or behind SCENE_MAX_OBJECTS a light
    bool unfit;  // without it the grader would not ask a variant
    int killed;  // changes that are killed with it and survive without it
    int example; // one of them, its number in the lab's; -1: none
} ObjectWorth;

enum { OBJECT_WORTH_MOST = 128 };

// Tries all changes of the lab with and without each of the things in the exam of the seed, by so many
// processes, and fills in the counts. False with a message: something could not be graded.
bool object_worth_find(LabChanges *changes, ObjectWorth *worths, int count, uint64_t seed, int processes);
