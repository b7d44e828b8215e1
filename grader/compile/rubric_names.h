// What one part of a lab's files may name of another: tasks and files.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>

// Is it a task of this lab: in lab 03 "3.1" to "3.31", or "3" for the whole lab? False with a message.
bool rubric_names_task(const Rubric *rubric, const JsonPlace *place, const char *task);

// Is a check about the task? Mistakes and hints belong to such tasks. False with a message.
bool rubric_names_asked(const Rubric *rubric, const JsonPlace *place, const char *task);

// Is it one of the files that students hand in? No message.
bool rubric_names_file(const Rubric *rubric, const char *name);
