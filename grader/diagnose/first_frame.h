// Does a lab draw right as long as it has drawn nothing else?
#pragma once

#include "diagnose/result.h"
#include "exam/exam.h"

// Draws the worst variant of the first failed check that can tell once more, as the first frame of a new
// worker. True when it is right then: the lab keeps something from one frame to the next. Of `student`
// folder, jail and context are taken.
bool first_frame_find(const LabResult *result, const Exam *exam, const bool failed[],
                      const WorkerClient *student);
