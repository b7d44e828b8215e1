// What stands at a TODO of a student's file: is it as it was handed out?
#pragma once

#include <stdbool.h>

typedef enum TaskText {
    TASK_TEXT_HANDED_OUT, // nothing was written there
    TASK_TEXT_WRITTEN,    // something was
    TASK_TEXT_EITHER,     // something was, here or at the TODO above or below
    TASK_TEXT_UNKNOWN     // the TODOs beside it are gone, so that it may be another task's
} TaskText;

// Compares what belongs to the mark "TODO(3.5)" at `at` in `text` with what belongs to the same mark of the
// same function in `skeleton`, the file as it was handed out. That is what follows it up to the next TODO or
// the end of the function; where code was put in above a function's first TODO and none below its last, what
// stands before it. Code right above the mark, below the words that were handed out there, may be its answer
// or that of the task above. Outside of functions it ends where the next function of the skeleton begins.
// Blanks and comments do not count.
TaskText task_text_compare(const char *text, const char *at, const char *mark, const char *skeleton);

// Does what follows the mark in `text` say more than in `without`, a version without the task's answer: that,
// and other words before it?
bool task_text_put_before(const char *text, const char *at, const char *mark, const char *without);
