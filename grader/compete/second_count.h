// A second count of a hand-in by another process: its shaders, drawn by our lab.c, so that no C of a
// submission runs beside the counters.
#pragma once

#include "compete/arena.h"
#include "compete/standing.h"
#include "compile/rubric.h"
#include "exam/worker_client.h"

// Holds what counts in the standing against the second count, and notes what is to be looked at: that the
// hand-in's own process has counted less, or that its shaders need its own lab.c. `student` lends its folder
// and limits, and `setting` is that of the standing. Notes nothing where there are no solutions.
void second_count(Standing *standing, const Arena *arena, const Rubric *rubric, const WorkerClient *student,
                  int setting);
