// The one annotated source of a lab. In C and GLSL:
//
//     #ifdef SOLUTION // 3.1
//         the answer to task 3.1
//     #else
//         TODO(3.1) and a stub
//     #endif
//
// From it come the solution (every task solved), the skeleton (none) and everything between. Plain text, no
// files.
#pragma once

#include <stdbool.h>

typedef struct Solved {
    enum { SOLVED_ALL, SOLVED_NONE, SOLVED_ALL_BUT, SOLVED_UP_TO, SOLVED_WITHOUT } which;
    const char
        *task; // of the last three; "3" stands for all tasks of lab 03; WITHOUT takes several: "3.4 3.6"
} Solved;

// One replacement of a text that must stand exactly once in its file.
typedef struct Edit {
    const char *file, *find, *replace;
} Edit;

// Returns `text` with each marked block reduced to one half; NULL with a message that names `name` and line
// when the markers do not fit together. With keep_lines the dropped lines stay as empty ones, so that line
// numbers are true. The caller frees the result.
char *task_blocks_select(const char *name, const char *text, Solved solved, bool keep_lines);

// Returns `text` with the edit applied; NULL with a message when edit->find is not there exactly once.
char *task_blocks_edit(const char *text, const Edit *edit);

// Calls visit for the task id of each marked block, in order.
void task_blocks_list(const char *text, void (*visit)(const char *task, void *context), void *context);

// Calls visit for the task id of each marked block of whose answer a line from `first` to `last`, both from
// 1, is a part.
void task_blocks_between(const char *text, int first, int last,
                         void (*visit)(const char *task, void *context), void *context);
