// Does a lab draw a frame in the same way whatever it drew before? The checks ask for first frames alone; in
// the window, what is not cleared between two frames is seen as soon as something moves.
#pragma once

#include "exam/exam.h"
#include "exam/worker_client.h"

// Draws one variant of the exam's last check of the picture, turns the camera, and draws again, with what is
// left of the frame before and without it. True when these two are the same, or when one of them does not
// come: the lab has passed, and there is nothing to say.
bool later_frame_is_same(const Exam *exam, WorkerClient *student);
