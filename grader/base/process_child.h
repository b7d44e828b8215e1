// What a child does between fork and exec.
#pragma once

#include "base/process_limits.h"

#include <sys/types.h>

// Takes the limits on this process itself: processor time, addresses, files.
void process_child_limit(const ProcessLimits *limits);

// `ends` become its descriptors 0, 1 and 2, and 3. Ends with 127 and a word on its output when something
// fails.
_Noreturn void process_child_run(const int ends[3], char *const *arguments, char *const *environment,
                                 const char *folder, const ProcessLimits *limits, pid_t parent);
