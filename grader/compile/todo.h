// Where a task of a lab is still to be done.
#pragma once

#include "compile/rubric.h"

#include <stdbool.h>
#include <stddef.h>

// Where "TODO(3.5)" stands first in the lab's files in `folder`: writes "shadow.frag:17", with the name that
// the file has there (find_file). False when it stands nowhere.
bool todo_find(const Rubric *rubric, const char *folder, const char *task, char *place, size_t size);
