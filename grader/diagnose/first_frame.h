// Does a lab draw right as long as it has drawn nothing else?
#pragma once

#include "diagnose/result.h"

// Draws the worst variant of failed check c again, as the first frame of a new worker. True when it is right
// then: the lab keeps something from one frame to the next. Of `student` folder, jail and context are taken.
bool first_frame_is_right(const CheckResult *check, const Exam *exam, int c, const WorkerClient *student);
