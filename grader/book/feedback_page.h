// A student's page as it is given away: under another name, or without points.
#pragma once

#include "class/roster.h"

#include <stdbool.h>

// Copies the entry's page from OUT/pages to `path`, with `name` in the place of the student's (NULL: as it
// is), and without points when `no_points`. False with a message, also when the page was made by a grader
// that did not mark them.
bool feedback_page_copy(const char *path, const char *output, const RosterEntry *entry, const char *name,
                        bool no_points);
