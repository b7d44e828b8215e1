// Does a lab draw a frame in the same way whatever it drew before? The checks ask for first frames alone; in
// the window, what is not cleared between two frames is seen as soon as something moves.
#pragma once

#include "exam/exam.h"
#include "exam/worker_client.h"

// Draws one variant of the exam's last check of the picture, turns the camera, and draws again, with what is
// left of the frame before and without it. The remark for who has passed: these two differ, or the second
// frame does not come; NULL when there is nothing to say. The worker may be lost afterwards: ask last.
const char *later_frame_remark(const Exam *exam, WorkerClient *student);
